#include <algorithm>

#include "drivers/wire/described/binary_bytes.hpp"
#include "drivers/wire/described/codec.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::wire::described {
namespace {

/// True if the header's own checksum is right, or has not come yet.
bool may_have_header(const Plan& plan, Bytes bytes) {
  if (!plan.header) return true;
  const HeaderChecksum& header = *plan.header;
  if (bytes.size() < header.end()) return true;
  const Bytes covered = bytes.first(header.to).subspan(header.from);
  return header.checksum.of(covered) ==
         load(bytes, header.at, header.checksum.size(), plan.checksum_big_endian);
}

/// True if the message can still begin with the bytes that came: its head, its constants and the
/// checksum of its header.
bool may_begin(const Plan& plan, const Message& message, Bytes bytes) {
  const std::size_t n = std::min(bytes.size(), message.head.size());
  for (std::size_t i = 0; i < n; ++i)
    if (bytes[i] != static_cast<std::uint8_t>(message.head[i])) return false;
  const bool others = std::ranges::any_of(plan.fields_of(message), [&](const Field& field) {
    const bool came = bytes.size() >= field.at + std::size_t{field.size};
    return field.type == Type::constant && !field.record && came && !has_constant(field, bytes);
  });
  return !others && may_have_header(plan, bytes);
}

/// True if the whole message has its checksum, with what it takes in behind it, and its end.
bool is_checked(const Plan& plan, std::string_view extra, Bytes frame) {
  const std::size_t size = plan.checksum.size();
  if (frame.size() < plan.least()) return false;
  const std::size_t content = frame.size() - plan.tail();
  if (as_text(frame.last(plan.end.size())) != plan.end) return false;
  if (size == 0) return true;
  const Bytes covered = frame.first(content).subspan(plan.checksum_from);
  const std::size_t at = plan.checksum_at.value_or(static_cast<std::uint16_t>(content));
  return plan.checksum.of(covered, bytes_of(extra)) ==
         load(frame, at, size, plan.checksum_big_endian);
}

/// The front of a line whose packets stand between delimiters.
Scan scan_stuffed(const Plan& plan, Bytes bytes) {
  const Scan whole = delimit(plan.stuffing, bytes, plan.longest);
  if (whole.kind != Scan::Kind::frame) return whole;
  // The last delimiter of a packet that is none can be the first one of the next packet.
  const std::size_t without_end =
      plan.stuffing == Stuffing::dle ? whole.size : std::max<std::size_t>(whole.size - 1, 1);
  Packet packet;
  if (!unstuff(plan.stuffing, bytes.first(whole.size), packet))
    return {Scan::Kind::bad_checksum, without_end};
  const auto named = std::ranges::find_if(plan.messages, [&](const Message& message) {
    return packet.size() >= message.head.size() && may_begin(plan, message, packet) &&
           has_length(message.length, packet);
  });
  const bool known = named != plan.messages.end();
  // Without a checksum only the name of a packet tells that it is one.
  const bool proven = plan.checksum.size() != 0 || known;
  const std::string_view extra = known ? std::string_view(named->extra) : std::string_view();
  if (proven && is_checked(plan, extra, packet)) return Scan::frame(whole.size);
  return {known ? Scan::Kind::bad_checksum : Scan::Kind::skip, without_end};
}

}  // namespace

Scan scan_binary(const Plan& plan, Bytes bytes) {
  if (plan.stuffing != Stuffing::none) return scan_stuffed(plan, bytes);
  // The shortest frame with a right checksum counts, so that the split of the stream changes
  // nothing: a longer one is judged only when no shorter one can still come.
  std::size_t best = 0, waits_for = 0;
  bool damaged = false;
  for (const Message& message : plan.messages) {
    if (!may_begin(plan, message, bytes)) continue;
    if (bytes.size() < message.head.size()) return Scan::need_more();
    const auto length = length_of(message.length, bytes);
    if (!length) return Scan::need_more();
    const std::size_t shortest =
        std::max({message.head.size() + plan.tail(), plan.least(), std::size_t{1}});
    if (*length < shortest || *length > plan.longest) continue;
    if (*length > bytes.size()) {
      waits_for = std::max(waits_for, *length);
    } else if (is_checked(plan, message.extra, bytes.first(*length))) {
      best = best == 0 ? *length : std::min(best, *length);
    } else {
      damaged = true;
    }
  }
  if (best > 0) return Scan::frame(best);
  if (waits_for > 0) return Scan::need_more(waits_for);
  return damaged ? Scan::bad_checksum() : Scan::skip(1);
}

}  // namespace drydock::wire::described

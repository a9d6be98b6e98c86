#include "drivers/wire/mavlink/mavlink.hpp"

#include <algorithm>
#include <variant>

#include "drivers/wire/mavlink/mavlink_kinds.hpp"
#include "drivers/wire/mavlink/mavlink_layout.hpp"

namespace drydock::wire {

namespace {

using namespace mavlink;

constexpr std::uint8_t start_1 = 0xFE, start_2 = 0xFD;
constexpr std::uint8_t is_signed = 1;  // the only flag that a reader of today understands
constexpr std::size_t header_1 = 6, header_2 = 10, checksum_size = 2, signature_size = 13;

/// What the first bytes of a frame say.
struct Header {
  std::size_t payload_at = 0, payload_size = 0, trailer = checksum_size;
  std::uint32_t id = 0;
  Sender sender;
  bool understood = true;

  std::size_t frame_size() const { return payload_at + payload_size + trailer; }
};

/// Empty: more bytes are needed.
std::optional<Header> header_of(Bytes bytes) {
  if (bytes.empty()) return {};
  if (bytes[0] == start_1) {
    if (bytes.size() < header_1) return {};
    return Header{header_1, bytes[1], checksum_size, bytes[5], {bytes[3], bytes[4], bytes[2]}};
  }
  if (bytes.size() < header_2) return {};
  const std::size_t trailer = checksum_size + (bytes[2] & is_signed ? signature_size : 0);
  const std::uint32_t id = load_le<std::uint16_t>(bytes, 7) | std::uint32_t{bytes[9]} << 16;
  return Header{header_2,
                bytes[1],
                trailer,
                id,
                {bytes[5], bytes[6], bytes[4]},
                (bytes[2] & ~is_signed) == 0};
}

struct Kind {
  std::uint32_t id;
  std::uint8_t crc_extra;
  std::string_view name;
};

template <class... M>
constexpr auto kinds_of(MessageList<M...>) {
  return std::array{Kind{M::id, crc_extra_of<M>(), M::type}...};
}
constexpr auto kinds = kinds_of(MavlinkMessages{});

std::optional<Kind> find_kind(std::uint32_t id) {
  const auto read = std::ranges::find(kinds, id, &Kind::id);
  if (read != kinds.end()) return *read;
  const auto named = std::ranges::lower_bound(unread_kinds, id, {}, &UnreadKind::id);
  if (named == unread_kinds.end() || named->id != id) return {};
  return Kind{id, named->crc_extra, named->name};
}

/// `checked`: from the byte behind the start to the end of the payload.
std::uint16_t checksum_of(Bytes checked, std::uint8_t crc_extra) {
  const auto state = checksum.add(checksum.add(checksum.start(), checked), Bytes{&crc_extra, 1});
  return static_cast<std::uint16_t>(checksum.finish(state));
}

std::size_t distance_to_start(Bytes bytes) {
  const auto found = std::ranges::find_if(
      bytes, [](std::uint8_t byte) { return byte == start_1 || byte == start_2; });
  return static_cast<std::size_t>(found - bytes.begin());
}

template <class... M>
std::optional<Mavlink::Message> read_as_kind(MessageList<M...>, std::uint32_t id, Bytes payload,
                                             const Sender& sender) {
  std::optional<Mavlink::Message> read;
  const auto try_kind = [&]<class One>(One message) {
    if (One::id != id) return false;
    PayloadReader reader(payload);
    One::lay_out(message, reader);
    message.sender = sender;
    read = message;
    return true;
  };
  (try_kind(M{}) || ...);
  return read;
}

/// A payload of all zeros keeps its first byte.
std::size_t without_last_zeros(Bytes payload) {
  std::size_t size = payload.size();
  while (size > 1 && payload[size - 1] == 0) --size;
  return size;
}

}  // namespace

/// Only who has its key can check a signature, so one that is cut short takes up to 13 bytes of the
/// frame behind it.
Scan Mavlink::scan(Bytes bytes) {
  if (const std::size_t noise = distance_to_start(bytes)) return Scan::skip(noise);
  const auto header = header_of(bytes);
  if (!header) return Scan::need_more();
  const auto kind = find_kind(header->id);
  if (!kind || !header->understood) return Scan::skip(1);
  const std::size_t size = header->frame_size();
  if (bytes.size() < size) return Scan::need_more(size);
  const std::size_t end = header->payload_at + header->payload_size;
  const auto sent = load_le<std::uint16_t>(bytes, end);
  return checksum_of(bytes.subspan(1, end - 1), kind->crc_extra) == sent ? Scan::frame(size)
                                                                         : Scan::bad_checksum();
}

std::optional<Mavlink::Message> Mavlink::decode(Bytes frame) {
  const auto header = header_of(frame);
  if (!header || frame.size() < header->frame_size()) return {};
  std::array<std::uint8_t, 255> payload{};
  std::ranges::copy(frame.subspan(header->payload_at, header->payload_size), payload.begin());
  return read_as_kind(MavlinkMessages{}, header->id, payload, header->sender);
}

std::string Mavlink::frame_name(Bytes frame) {
  const auto header = header_of(frame);
  const auto kind = header ? find_kind(header->id) : std::nullopt;
  return "MAVLink " + (kind ? std::string(kind->name) : "frame");
}

std::size_t mavlink::encode(const Mavlink::Message& message, std::span<std::uint8_t> out) {
  return std::visit(
      [out](const auto& m) -> std::size_t {
        using M = std::decay_t<decltype(m)>;
        std::array<std::uint8_t, 255> payload{};
        PayloadWriter writer(payload);
        M::lay_out(m, writer);
        const std::size_t size = without_last_zeros(Bytes{payload}.first(writer.size()));
        const std::size_t end = header_2 + size;
        if (out.size() < end + checksum_size) return 0;
        out[0] = start_2;
        out[1] = static_cast<std::uint8_t>(size);
        out[2] = out[3] = 0;
        out[4] = m.sender.sequence;
        out[5] = m.sender.system;
        out[6] = m.sender.component;
        store_le<std::uint16_t>(out, 7, static_cast<std::uint16_t>(M::id));
        out[9] = static_cast<std::uint8_t>(M::id >> 16);
        std::ranges::copy(Bytes{payload}.first(size), out.begin() + header_2);
        store_le<std::uint16_t>(out, end, checksum_of(out.subspan(1, end - 1), crc_extra_of<M>()));
        return end + checksum_size;
      },
      message);
}

}  // namespace drydock::wire

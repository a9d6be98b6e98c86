#include <algorithm>

#include "drivers/wire/described/codec.hpp"
#include "drivers/wire/line_end.hpp"

/// Where a sentence or a line begins and ends.
namespace drydock::wire::described {
namespace {

constexpr bool ends_a_line(std::uint8_t c) { return c == '\r' || c == '\n'; }
constexpr bool is_printable(std::uint8_t c) { return (c >= 0x20 && c <= 0x7E) || c == '\t'; }

/// Above Fh: it is no digit.
constexpr unsigned hex_digit(std::uint8_t c) {
  if (c >= '0' && c <= '9') return c - unsigned{'0'};
  const unsigned letter = c | 0x20u;
  return letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : 0x100;
}

/// A line may have letters that are not of ASCII, such as a degree sign in any encoding.
constexpr bool is_of_line(std::uint8_t c) { return is_printable(c) || c >= 0x80; }

Scan at_star(const Plan& plan, Bytes bytes, std::size_t star) {
  const std::size_t digits = plan.checksum_digits();
  if (bytes.size() < star + 1 + digits) return Scan::need_more();
  std::uint32_t sent = 0;
  for (const std::uint8_t c : bytes.subspan(star + 1, digits)) {
    const unsigned digit = hex_digit(c);
    if (digit > 15) return Scan::skip(1);
    sent = sent << 4 | digit;
  }
  const Bytes covered = bytes.first(star).subspan(std::min<std::size_t>(plan.checksum_from, star));
  return sent == plan.checksum.of(covered) ? with_line_end(bytes, star + 1 + digits)
                                           : Scan::bad_checksum();
}

bool begins_message(const Plan& plan, Bytes bytes) {
  if (bytes[0] == '$') return true;
  return std::ranges::any_of(plan.texts.families,
                             [&](const FlatFamily& family) { return begins(family, bytes); });
}

}  // namespace

Scan scan_sentence(const Plan& plan, Bytes bytes) {
  const bool checked = plan.checksum.size() != 0;
  const std::size_t limit = std::min(bytes.size(), plan.longest);
  for (std::size_t i = 1; i < limit; ++i) {
    const std::uint8_t c = bytes[i];
    if (!plan.texts.stops[c]) continue;
    if (c == '*' && checked) return at_star(plan, bytes, i);
    if (ends_a_line(c) && (!checked || plan.checksum_optional)) return with_line_end(bytes, i);
    if (!is_printable(c)) return Scan::skip(1);
    if (plan.starts[c] && begins_message(plan, bytes.subspan(i))) return Scan::skip(i);
  }
  return limit < bytes.size() || limit == plan.longest ? Scan::skip(1) : Scan::need_more();
}

Scan scan_line(const Plan& plan, Bytes bytes) {
  const std::size_t limit = std::min(bytes.size(), plan.longest);
  std::size_t end = 0;
  while (end < limit && is_of_line(bytes[end])) ++end;
  if (end == limit) return limit == plan.longest ? Scan::skip(1) : Scan::need_more();
  if (!ends_a_line(bytes[end])) return Scan::skip(end);
  Record record;
  if (decode_texts(plan, bytes.first(end), record) == Decoded::message)
    return with_line_end(bytes, end);
  const bool any_start = std::ranges::any_of(plan.messages, &std::string::empty, &Message::head);
  return Scan::skip(any_start ? end : 1);
}

}  // namespace drydock::wire::described

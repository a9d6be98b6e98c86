#include "drivers/wire/pgn_table/text.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "drivers/wire/pgn_table/bits.hpp"

namespace drydock::wire::pgn_table {
namespace {

/// The bytes of a slice; the last may have fewer bits.
std::vector<std::uint8_t> bytes_of(const Slice& slice) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(slice.bits / 8 + 1);
  for (std::size_t at = 0; at < slice.bits; at += 8) {
    const std::size_t count = std::min<std::size_t>(8, slice.bits - at);
    const auto byte = bits_at(slice.bytes, slice.first_bit + at, count);
    if (!byte) break;
    bytes.push_back(static_cast<std::uint8_t>(*byte));
  }
  return bytes;
}

void append_utf8(std::string& text, std::uint32_t c) {
  const auto put = [&](std::uint32_t byte) { text.push_back(static_cast<char>(byte)); };
  if (c < 0x80) return put(c);
  if (c < 0x800) {
    put(0xC0 | c >> 6);
  } else {
    put(0xE0 | c >> 12);
    put(0x80 | (c >> 6 & 0x3F));
  }
  put(0x80 | (c & 0x3F));
}

/// No character has two forms in UTF-8, and none is half of a UTF-16 pair.
bool may_be_second(std::uint8_t lead, std::uint8_t second) {
  switch (lead) {
    case 0xE0: return second >= 0xA0;
    case 0xED: return second < 0xA0;
    case 0xF0: return second >= 0x90;
    case 0xF4: return second < 0x90;
    default: return true;
  }
}

/// Length of the UTF-8 character at the beginning; 0: it is none.
std::size_t utf8_length(Bytes bytes) {
  const std::uint8_t lead = bytes[0];
  if (lead < 0x80) return 1;
  const std::size_t length = lead < 0xC2 || lead > 0xF4 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  if (length == 0 || length > bytes.size() || !may_be_second(lead, bytes[1])) return 0;
  const bool whole = std::ranges::all_of(bytes.subspan(1, length - 1),
                                         [](std::uint8_t b) { return (b & 0xC0) == 0x80; });
  return whole ? length : 0;
}

std::string utf8_of(Bytes bytes) {
  std::string text;
  while (!bytes.empty()) {
    const std::size_t length = utf8_length(bytes);
    if (length == 0) append_utf8(text, bytes[0]);
    for (std::size_t i = 0; i < length; ++i) text.push_back(static_cast<char>(bytes[i]));
    bytes = bytes.subspan(std::max<std::size_t>(length, 1));
  }
  return text;
}

/// Half of a pair comes out as U+FFFD; no device is known that sends one.
std::string utf8_of_utf16(Bytes bytes) {
  constexpr std::uint32_t replacement = 0xFFFD;
  std::string text;
  for (; bytes.size() >= 2; bytes = bytes.subspan(2)) {
    const auto c = static_cast<std::uint32_t>(bytes[0] | bytes[1] << 8);
    append_utf8(text, c >= 0xD800 && c < 0xE000 ? replacement : c);
  }
  return text;
}

Bytes until_zero(Bytes bytes) {
  const auto end = std::ranges::find(bytes, 0);
  return bytes.first(static_cast<std::size_t>(end - bytes.begin()));
}

Bytes unpadded(Bytes bytes) {
  const auto pads = [](std::uint8_t b) { return b == '@' || b == ' ' || b == 0 || b == 0xFF; };
  while (!bytes.empty() && pads(bytes.back())) bytes = bytes.first(bytes.size() - 1);
  return bytes;
}

Extent of_text(std::string text, std::size_t bits) {
  Extent extent;
  extent.bits = bits;
  if (!text.empty()) extent.value.content = Text{std::move(text)};
  return extent;
}

}  // namespace

Extent read_fixed_text(const Slice& slice) {
  const auto bytes = bytes_of(slice);
  return of_text(utf8_of(unpadded(until_zero(bytes))), slice.bits);
}

Extent read_text_with_length(const Slice& slice) {
  const auto bytes = bytes_of(slice);
  if (bytes.empty()) return {};
  const std::size_t size = std::min<std::size_t>(bytes[0], bytes.size() - 1);
  return of_text(utf8_of(until_zero(Bytes{bytes}.subspan(1, size))), 8 * (size + 1));
}

Extent read_text_with_kind(const Slice& slice) {
  const auto bytes = bytes_of(slice);
  if (bytes.size() < 2 || bytes[0] < 2) return of_text({}, std::min<std::size_t>(16, slice.bits));
  const std::size_t size = std::min<std::size_t>(bytes[0], bytes.size());
  const Bytes characters = Bytes{bytes}.subspan(2, size - 2);
  return of_text(bytes[1] == 0 ? utf8_of_utf16(characters) : utf8_of(until_zero(characters)),
                 8 * size);
}

Extent read_decimal(const Slice& slice) {
  std::string digits;
  for (const std::uint8_t byte : bytes_of(slice)) {
    if (byte > 99) return of_text({}, slice.bits);
    digits.push_back(static_cast<char>('0' + byte / 10));
    digits.push_back(static_cast<char>('0' + byte % 10));
  }
  return of_text(std::move(digits), slice.bits);
}

Extent read_bytes(const Slice& slice) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text;
  for (const std::uint8_t byte : bytes_of(slice)) {
    text.push_back(digits[byte >> 4]);
    text.push_back(digits[byte & 15]);
  }
  return of_text(std::move(text), slice.bits);
}

}  // namespace drydock::wire::pgn_table

#include "drivers/text/printable.hpp"

#include <algorithm>
#include <cstdint>

namespace drydock::text {
namespace {

std::uint8_t byte(char c) { return static_cast<std::uint8_t>(c); }

/// Bytes of the character that begins with this byte; 0 if none does.
std::size_t size_of(std::uint8_t first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

/// RFC 3629: neither longer than necessary, nor a surrogate, nor beyond U+10FFFF.
bool second_fits(std::uint8_t first, std::uint8_t second) {
  const std::uint8_t lowest = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const std::uint8_t highest = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  return second >= lowest && second <= highest;
}

bool is_control(std::string_view character) {
  const std::uint8_t first = byte(character[0]);
  if (character.size() == 1) return first < 0x20 || first == 0x7F;
  return first == 0xC2 && byte(character[1]) < 0xA0;  // U+0080 to U+009F
}

/// XML allows neither U+FFFE nor U+FFFF.
bool is_no_character(std::string_view character) {
  return character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";
}

/// Bytes of the character at the front that people may see; 0 if it is none.
std::size_t shown_at_front(std::string_view bytes) {
  const std::size_t size = size_of(byte(bytes[0]));
  if (size == 0 || size > bytes.size()) return 0;
  const std::string_view character = bytes.substr(0, size);
  if (size > 1 && !second_fits(byte(bytes[0]), byte(bytes[1]))) return 0;
  const auto continues = [](char c) { return (byte(c) & 0xC0) == 0x80; };
  if (!std::ranges::all_of(character.substr(1), continues)) return 0;
  return is_control(character) || is_no_character(character) ? 0 : size;
}

}  // namespace

std::string printable(std::string_view bytes) {
  std::string out;
  out.reserve(bytes.size());
  while (!bytes.empty()) {
    const std::size_t size = shown_at_front(bytes);
    out += size == 0 ? std::string_view("?") : bytes.substr(0, size);
    bytes.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return out;
}

}  // namespace drydock::text

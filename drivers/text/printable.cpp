#include "drivers/text/printable.hpp"

#include <algorithm>
#include <cstdint>

#include "drivers/wire/utf8.hpp"

namespace drydock::text {
namespace {

std::uint8_t byte(char c) { return static_cast<std::uint8_t>(c); }

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
  const std::size_t size = wire::utf8_at_front(bytes);
  const std::string_view character = bytes.substr(0, size);
  if (size == 0) return 0;
  return is_control(character) || is_no_character(character) ? 0 : size;
}

/// `kept`: control characters that stay.
std::string shown(std::string_view bytes, std::string_view kept) {
  std::string out;
  out.reserve(bytes.size());
  while (!bytes.empty()) {
    const std::size_t size = kept.find(bytes[0]) != kept.npos ? 1 : shown_at_front(bytes);
    out += size == 0 ? std::string_view("?") : bytes.substr(0, size);
    bytes.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return out;
}

}  // namespace

std::string printable(std::string_view bytes) { return shown(bytes, ""); }
std::string printable_lines(std::string_view text) { return shown(text, "\n\t"); }

}  // namespace drydock::text

#include "drivers/text/json_lines.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "drivers/wire/utf8.hpp"

namespace drydock::text {

namespace {

/// A byte as the character with this number.
char* put_escaped(char* at, unsigned char byte) {
  constexpr std::string_view hex = "0123456789abcdef";
  at = std::ranges::copy(std::string_view{"\\u00"}, at).out;
  *at++ = hex[byte >> 4];
  *at++ = hex[byte & 0xF];
  return at;
}

/// Bytes that stand for themselves.
constexpr auto plain = [] {
  std::array<bool, 256> is{};
  for (unsigned byte = 0x20; byte < 0x7F; ++byte) is[byte] = byte != '"' && byte != '\\';
  return is;
}();

/// There is room for six characters.
char* put_character_of_text(char* at, char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte < 0x20 || byte == 0x7F) return put_escaped(at, byte);
  if (c == '"' || c == '\\') *at++ = '\\';
  *at++ = c;
  return at;
}

bool is_utf8(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t size = wire::utf8_at_front(bytes);
    if (size == 0) return false;
    bytes.remove_prefix(size);
  }
  return true;
}

}  // namespace

char* JsonWriter::put(char* at, std::string_view text) {
  if (text.empty()) return null(at);
  at = out_.room(at, 6 * text.size() + 2);
  *at++ = '"';
  // A text that is UTF-8 is nothing else: German, French or a degree sign in Latin-1 is no UTF-8.
  // In any other text a byte becomes its Latin-1 character, so that the line stays valid JSON.
  std::optional<bool> utf8;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (plain[byte]) {
      *at++ = c;
      continue;
    }
    if (byte >= 0x80 && !utf8) utf8 = is_utf8(text);
    at = byte < 0x80 || *utf8 ? put_character_of_text(at, c) : put_escaped(at, byte);
  }
  *at++ = '"';
  return at;
}

char* JsonWriter::put_utf8(char* at, std::string_view text) {
  if (text.empty()) return null(at);
  at = out_.room(at, 6 * text.size() + 2);
  *at++ = '"';
  for (const char c : text) at = put_character_of_text(at, c);
  *at++ = '"';
  return at;
}

bool JsonLines::flush() {
  sound_ = sound_ && std::fwrite(text_.view().data(), 1, text_.size(), file_) == text_.size() &&
           std::fflush(file_) == 0;
  text_.clear();
  return sound_;
}

}  // namespace drydock::text

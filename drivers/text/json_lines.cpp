#include "drivers/text/json_lines.hpp"

#include <algorithm>
#include <array>

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

}  // namespace

char* JsonWriter::put(char* at, std::string_view text) {
  if (text.empty()) return null(at);
  at = out_.room(at, 6 * text.size() + 2);
  *at++ = '"';
  // Text on the wire is ASCII. Any other byte becomes its Latin-1 character, so that the line stays
  // valid JSON.
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (plain[byte])
      *at++ = c;
    else
      at = byte < 0x80 ? put_character_of_text(at, c) : put_escaped(at, byte);
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

#include "drivers/text/json_lines.hpp"

#include <algorithm>

namespace drydock::text {

char* JsonWriter::put(char* at, std::string_view text) {
  if (text.empty()) return null(at);
  constexpr std::string_view hex = "0123456789abcdef";
  at = out_.room(at, 6 * text.size() + 2);
  *at++ = '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      *at++ = '\\';
      *at++ = c;
    } else if (byte < 0x20 || byte >= 0x7F) {
      // Text on the wire is ASCII. Any other byte becomes its Latin-1 character, so that the line
      // stays valid JSON.
      at = std::ranges::copy(std::string_view{"\\u00"}, at).out;
      *at++ = hex[byte >> 4];
      *at++ = hex[byte & 0xF];
    } else {
      *at++ = c;
    }
  }
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

#include "drivers/cli/json_lines.hpp"

namespace drydock::cli {

void JsonWriter::value(std::string_view text) {
  if (text.empty()) {
    out_ += "null";
    return;
  }
  constexpr std::string_view hex = "0123456789abcdef";
  out_ += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out_ += '\\';
      out_ += c;
    } else if (byte < 0x20 || byte >= 0x7F) {
      // Wire text is ASCII; any other byte is shown as its Latin-1 character, so the line stays
      // JSON.
      out_ += "\\u00";
      out_ += hex[byte >> 4];
      out_ += hex[byte & 0xF];
    } else {
      out_ += c;
    }
  }
  out_ += '"';
}

bool JsonLines::flush() {
  sound_ = sound_ && std::fwrite(text_.data(), 1, text_.size(), file_) == text_.size() &&
           std::fflush(file_) == 0;
  text_.clear();
  return sound_;
}

}  // namespace drydock::cli

#include "drivers/monitor/cut_row.hpp"

namespace drydock::monitor {

namespace {

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// Bytes of the escape sequence at the beginning: ESC [ ... letter.
std::size_t escape_length(std::string_view text) {
  const auto letter = text.find_first_of("ABCDEFGHJKLMSTfhilmnrsu", 2);
  return letter == std::string_view::npos ? text.size() : letter + 1;
}

}  // namespace

std::string cut_row(std::string_view line, std::size_t width) {
  std::string cut;
  std::size_t columns = 0;
  while (!line.empty()) {
    std::size_t length = 1;
    if (line.starts_with("\033[")) {
      length = escape_length(line);
      cut += line.substr(0, length);
    } else {
      if (!continues_character(line.front())) ++columns;
      if (columns <= width) cut += line.front();
    }
    line.remove_prefix(length);
  }
  return cut;
}

}  // namespace drydock::monitor

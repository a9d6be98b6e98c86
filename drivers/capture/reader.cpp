#include "drivers/capture/reader.hpp"

#include <algorithm>

namespace drydock::capture {

Scan scan_line(Bytes bytes, bool at_end) {
  const Bytes window = bytes.first(std::min(bytes.size(), LineReader::longest_line));
  const auto end = std::find_if(window.begin(), window.end(),
                                [](std::uint8_t byte) { return byte == '\n' || byte == '\r'; });
  if (end == window.end()) {
    if (window.size() == LineReader::longest_line) return Scan::skip(window.size());
    return at_end && !window.empty() ? Scan::frame(window.size()) : Scan::need_more();
  }
  const auto size = static_cast<std::size_t>(end - window.begin()) + 1;
  if (*end == '\n') return Scan::frame(size);
  if (size == bytes.size()) return at_end ? Scan::frame(size) : Scan::need_more();
  return Scan::frame(size + (bytes[size] == '\n'));
}

std::string_view text_of(Bytes line) {
  std::string_view text{reinterpret_cast<const char*>(line.data()), line.size()};
  while (text.ends_with('\n') || text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

Scan LineReader::scan(Bytes bytes, bool at_end) { return scan_line(bytes, at_end); }

Reading LineReader::read(Bytes unit) {
  const std::string_view line = text_of(unit);
  return line.find_first_not_of(" \t") == line.npos ? Reading::nothing() : read_line(line);
}

}  // namespace drydock::capture

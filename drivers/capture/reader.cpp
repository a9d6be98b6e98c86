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
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF", around = " \t\r\n";
  std::string_view text{reinterpret_cast<const char*>(line.data()), line.size()};
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  text.remove_prefix(std::min(text.find_first_not_of(around), text.size()));
  return text.substr(0, text.find_last_not_of(around) + 1);
}

Scan LineReader::scan(Bytes bytes, bool at_end) { return scan_line(bytes, at_end); }

Reading LineReader::read(Bytes unit) {
  const std::string_view line = text_of(unit);
  return line.empty() ? Reading::nothing() : read_line(line);
}

}  // namespace drydock::capture

#include "drivers/monitor/screen/pane_line.hpp"

#include <algorithm>

namespace drydock::monitor {
namespace {

constexpr std::size_t narrowest = 20;  // a screen that is narrower cuts the lines off

}  // namespace

void add_wrapped(std::vector<PaneLine>& lines, std::string text, std::size_t width, Style style) {
  width = std::max(width, narrowest);
  while (cells_of(text) > width) {
    auto at = text.rfind(' ', width);
    if (at == std::string::npos || at < width / 2) at = width;
    lines.push_back({{text.substr(0, at), style}});
    text = "  " + text.substr(text[at] == ' ' ? at + 1 : at);
  }
  lines.push_back({{std::move(text), style}});
}

std::size_t cells_of(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(std::string text, std::size_t width) {
  const auto cells = cells_of(text);
  if (cells < width) text.append(width - cells, ' ');
  return text;
}

}  // namespace drydock::monitor

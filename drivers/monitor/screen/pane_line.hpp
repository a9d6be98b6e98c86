#pragma once

#include <string>
#include <vector>

#include "drivers/monitor/screen/canvas.hpp"

namespace drydock::monitor {

struct Span {
  std::string text;
  Style style = Style::plain;
};

/// A line of a pane: texts of different styles, one behind the other.
using PaneLine = std::vector<Span>;

/// Adds a text, broken between words into lines of at most `width`; lines but the first begin
/// two blanks further in.
void add_wrapped(std::vector<PaneLine>& lines, std::string text, std::size_t width,
                 Style style = Style::plain);

/// Cells that a UTF-8 text takes.
std::size_t cells_of(std::string_view text);
std::string padded(std::string text, std::size_t width);

}  // namespace drydock::monitor

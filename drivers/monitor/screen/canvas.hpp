#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::monitor {

enum class Style : std::uint8_t {
  plain,
  title,
  heading,
  good,
  waiting,
  wrong,
  changed,
  chosen,
  dim
};

struct Cell {
  char32_t glyph = U' ';
  Style style = Style::plain;
};

/// A terminal in memory: rows of cells. What does not fit is cut off; nothing is ever wrapped.
/// Control characters and what takes more than a cell become '?'.
class Canvas {
 public:
  Canvas(std::size_t width, std::size_t height)
      : width_(width), height_(height), cells_(width * height) {}

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  const Cell& at(std::size_t row, std::size_t column) const {
    return cells_[row * width_ + column];
  }

  /// Writes UTF-8 text; gives the column behind it, also where that is outside.
  std::size_t put(std::size_t row, std::size_t column, std::string_view text,
                  Style style = Style::plain);
  void fill(std::size_t row, Style style);          ///< the style of a whole row
  std::string text(std::size_t row) const;          ///< UTF-8, without blanks at the end
  std::string marks(std::size_t row, Style) const;  ///< '^' under each cell of a style

 private:
  std::size_t width_, height_;
  std::vector<Cell> cells_;
};

}  // namespace drydock::monitor

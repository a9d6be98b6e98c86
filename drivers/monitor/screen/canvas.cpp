#include "drivers/monitor/screen/canvas.hpp"

namespace drydock::monitor {
namespace {

constexpr char32_t first_wide = 0x1100;  // from here on a glyph may take two cells

/// Takes one character from the front of a UTF-8 text.
char32_t take_glyph(std::string_view& text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t size = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  char32_t glyph = size == 1 ? lead : lead & (0xFFU >> (size + 1));
  for (std::size_t i = 1; i < size && i < text.size(); ++i)
    glyph = glyph << 6 | (static_cast<unsigned char>(text[i]) & 0x3FU);
  text.remove_prefix(std::min(size, text.size()));
  const bool control = glyph < 0x20 || (glyph >= 0x7F && glyph < 0xA0);
  return control || glyph >= first_wide ? U'?' : glyph;
}

void append_utf8(std::string& text, char32_t glyph) {
  if (glyph < 0x80) {
    text += static_cast<char>(glyph);
  } else if (glyph < 0x800) {
    text += static_cast<char>(0xC0U | glyph >> 6);
    text += static_cast<char>(0x80U | (glyph & 0x3FU));
  } else {
    text += static_cast<char>(0xE0U | glyph >> 12);
    text += static_cast<char>(0x80U | (glyph >> 6 & 0x3FU));
    text += static_cast<char>(0x80U | (glyph & 0x3FU));
  }
}

std::string without_end_blanks(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace

std::size_t Canvas::put(std::size_t row, std::size_t column, std::string_view text, Style style) {
  for (; !text.empty(); ++column) {
    const char32_t glyph = take_glyph(text);
    if (row < height_ && column < width_) cells_[row * width_ + column] = {glyph, style};
  }
  return column;
}

void Canvas::fill(std::size_t row, Style style) {
  for (std::size_t column = 0; row < height_ && column < width_; ++column)
    cells_[row * width_ + column].style = style;
}

std::string Canvas::text(std::size_t row) const {
  std::string text;
  for (std::size_t column = 0; column < width_; ++column) append_utf8(text, at(row, column).glyph);
  return without_end_blanks(std::move(text));
}

std::string Canvas::marks(std::size_t row, Style style) const {
  std::string text;
  for (std::size_t column = 0; column < width_; ++column)
    text += at(row, column).style == style ? '^' : ' ';
  return without_end_blanks(std::move(text));
}

}  // namespace drydock::monitor

#include "hil/scorecard/heat_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hil/report/html.hpp"

namespace drydock::scorecard {
namespace {

constexpr double row_px = 20, label_px = 170, panel_gap_px = 12, top_px = 96, font_px = 12;
constexpr double title_letter_px = 7.5;  // width of a bold 12 px letter, a little too wide

struct Colour {
  std::array<double, 3> rgb;
};
constexpr Colour lightest{{{236, 243, 250}}}, darkest{{{8, 64, 129}}};
constexpr std::string_view amber = "#F4D58A", vermilion = "#D55E00", nothing = "#F3F3F3";

std::string fill_of(const HeatCell& cell) {
  switch (cell.tone) {
    case Tone::none: return std::string(nothing);
    case Tone::unseen: return std::string(amber);
    case Tone::alarm: return std::string(vermilion);
    case Tone::shade: break;
  }
  const double level = std::clamp(cell.level, 0.0, 1.0);
  std::array<int, 3> mixed{};
  for (std::size_t i = 0; i < 3; ++i)
    mixed.at(i) = static_cast<int>(
        std::lround(lightest.rgb.at(i) + level * (darkest.rgb.at(i) - lightest.rgb.at(i))));
  return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

std::string_view ink_on(const HeatCell& cell) {
  const bool dark = cell.tone == Tone::alarm || (cell.tone == Tone::shade && cell.level > 0.5);
  return dark ? "#fff" : "#1b1f24";
}

std::string cell_svg(const HeatCell& cell, double x, double y, double width) {
  std::string out =
      fmt::format("<rect x='{:.0f}' y='{:.0f}' width='{:.0f}' height='{:.0f}' fill='{}'/>", x, y,
                  width - 1, row_px - 1, fill_of(cell));
  if (!cell.text.empty())
    out += fmt::format("<text x='{:.1f}' y='{:.0f}' text-anchor='middle' fill='{}'>{}</text>",
                       x + (width - 1) / 2, y + 14, ink_on(cell), report::html::escaped(cell.text));
  if (!cell.tip.empty())
    out = fmt::format("<g><title>{}</title>{}</g>", report::html::escaped(cell.tip), out);
  return out + "\n";
}

std::size_t columns_of(const HeatMap& map) {
  std::size_t n = 0;
  for (const auto& panel : map.panels) n += panel.columns.size();
  return n;
}

struct Layout {
  std::vector<double> columns;  ///< left edge of each
  double right = label_px;
};

/// Each panel is as wide as its columns and its title need, with a gap before the next one.
Layout layout_of(const HeatMap& map) {
  Layout layout;
  for (const auto& panel : map.panels) {
    const double left = layout.right + (layout.columns.empty() ? 0 : panel_gap_px);
    double right = left;
    for (std::size_t i = 0; i < panel.columns.size(); ++i, right += map.column_px)
      layout.columns.push_back(right);
    const auto title = title_letter_px * static_cast<double>(panel.title.size());
    layout.right = std::max(right, left + title);
  }
  return layout;
}

std::string headings(const HeatMap& map, const std::vector<double>& places) {
  std::string out;
  std::size_t column = 0;
  for (const auto& panel : map.panels) {
    out += fmt::format("<text x='{:.0f}' y='38' font-weight='600'>{}</text>\n", places[column],
                       report::html::escaped(panel.title));
    for (const auto& name : panel.columns) {
      const double x = places[column++] + map.column_px / 2;
      out += fmt::format(
          "<text x='{0:.0f}' y='{1:.0f}' transform='rotate(-40 {0:.0f} {1:.0f})'>{2}</text>\n", x,
          top_px - 6, report::html::escaped(name));
    }
  }
  return out;
}

}  // namespace

double log_level(double x, double low, double high) {
  if (x <= low) return 0;
  return std::min(1.0, std::log(x / low) / std::log(high / low));
}

std::string to_svg(const HeatMap& map) {
  if (columns_of(map) == 0) return {};
  const Layout layout = layout_of(map);
  const double width = layout.right + 40;
  const double height = top_px + row_px * static_cast<double>(map.rows.size()) + 10;
  std::string out = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0:.0f} {1:.0f}' width='{0:.0f}' "
      "font-family='system-ui,sans-serif' font-size='{2:.0f}' fill='#1b1f24'>\n"
      "<rect width='100%' height='100%' fill='#fff'/>\n"
      "<text x='8' y='16' font-size='14' font-weight='600'>{3}</text>\n",
      width, height, font_px, report::html::escaped(map.title));
  out += headings(map, layout.columns);
  double y = top_px;
  for (const auto& row : map.rows) {
    const bool heading = row.cells.empty();
    out += fmt::format("<text x='8' y='{:.0f}'{}>{}</text>\n", y + 14,
                       heading ? " font-weight='600' fill='#57606a'" : "",
                       report::html::escaped(row.label));
    for (std::size_t i = 0; i < row.cells.size(); ++i)
      out += cell_svg(row.cells[i], layout.columns[i], y, map.column_px);
    y += row_px;
  }
  return out + "</svg>\n";
}

}  // namespace drydock::scorecard

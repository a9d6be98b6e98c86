#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace drydock::scorecard {

enum class Tone : std::uint8_t {
  none,    ///< an empty cell
  shade,   ///< light to dark with `level`
  unseen,  ///< its own colour; it is not a defect
  alarm
};

struct HeatCell {
  std::string text;
  Tone tone = Tone::none;
  double level = 0;  ///< for Tone::shade: 0 light to 1 dark
  std::string tip;   ///< text under the pointer
};

/// Columns under one common heading.
struct HeatPanel {
  std::string title;
  std::vector<std::string> columns;
};

struct HeatRow {
  std::string label;
  std::vector<HeatCell> cells;  ///< one per column of all panels; none: the row is a heading
};

struct HeatMap {
  std::string title;
  std::vector<HeatPanel> panels;
  std::vector<HeatRow> rows;
  double column_px = 44;
};

/// A self-contained SVG element. Its colours are blue shades, amber and vermilion, which people who
/// confuse red and green can distinguish (Okabe and Ito, Color Universal Design, 2008). Every cell
/// has its number.
std::string to_svg(const HeatMap& map);

/// The position of x between low and high on a logarithmic scale, 0 to 1.
double log_level(double x, double low, double high);

}  // namespace drydock::scorecard

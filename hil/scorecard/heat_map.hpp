#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace drydock::scorecard {

enum class Tone : std::uint8_t {
  none,    ///< nothing to tell: an empty cell
  shade,   ///< light to dark with `level`
  unseen,  ///< a value of its own that is no defect
  alarm
};

struct HeatCell {
  std::string text;
  Tone tone = Tone::none;
  double level = 0;  ///< of a shade: 0 light to 1 dark
  std::string tip;   ///< shown under the pointer
};

/// Columns that belong together, under one heading.
struct HeatPanel {
  std::string title;
  std::vector<std::string> columns;
};

struct HeatRow {
  std::string label;
  std::vector<HeatCell> cells;  ///< as many as all panels have columns; none: a heading
};

struct HeatMap {
  std::string title;
  std::vector<HeatPanel> panels;
  std::vector<HeatRow> rows;
  double column_px = 44;
};

/// An SVG element that stands alone: blue shades, amber, vermilion, which people who confuse red
/// and green tell apart (Okabe and Ito, Color Universal Design, 2008); every cell has its number.
std::string to_svg(const HeatMap& map);

/// Where x stands between low and high by its logarithm, 0 to 1.
double log_level(double x, double low, double high);

}  // namespace drydock::scorecard

#include "hil/world/sky_plot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "drivers/measurement/units.hpp"

namespace drydock::world {
namespace {

constexpr double middle = 320, horizon = 270;  // in units of the drawing
constexpr double right_angle = std::numbers::pi / 2;

struct Point {
  double x, y;
};

Point on_plot(const sky::Look& look) {
  const double r = horizon * (1 - look.elevation_rad / right_angle);
  return {middle + r * std::sin(look.azimuth_rad), middle - r * std::cos(look.azimuth_rad)};
}

std::string grid() {
  std::string svg;
  for (const int elevation : {0, 30, 60}) {
    const double r = horizon * (1 - elevation / 90.0);
    svg += fmt::format("<circle cx='{0}' cy='{0}' r='{1:.1f}' fill='none' stroke='#bbbbbb'/>\n",
                       middle, r);
    svg += fmt::format("<text x='{}' y='{:.1f}' fill='#777777' font-size='11'>{}°</text>\n",
                       middle + 4, middle - r + 13, elevation);
  }
  for (int azimuth = 0; azimuth < 360; azimuth += 30) {
    const double a = azimuth * right_angle / 90, x = std::sin(a), y = -std::cos(a);
    svg += fmt::format("<line x1='{0}' y1='{0}' x2='{1:.1f}' y2='{2:.1f}' stroke='#e2e2e2'/>\n",
                       middle, middle + horizon * x, middle + horizon * y);
    const std::string label =
        azimuth % 90 ? fmt::format("{}°", azimuth) : std::string(1, "NESW"[azimuth / 90]);
    svg += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>{}</text>\n",
                       middle + (horizon + 20) * x, middle + (horizon + 20) * y + 5, label);
  }
  return svg;
}

/// The track of the last hour, as far as it was above the horizon.
std::string way(const SkyListing& listing, const SkyRow& row) {
  std::string points;
  for (int minute = 60; minute >= 0; minute -= 5) {
    const auto look = look_at(row.record, listing.at - std::chrono::minutes{minute}, *listing.from);
    if (look.elevation_rad < 0) continue;
    const Point p = on_plot(look);
    points += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
  }
  return fmt::format("<polyline points='{}' fill='none' stroke='#56b4e9' stroke-width='2'/>\n",
                     points);
}

std::string satellite(const SkyRow& row) {
  const Point p = on_plot(*row.look);
  const char* colour = row.record.healthy() ? "#0072b2" : "#d55e00";
  return fmt::format(
      "<circle cx='{0:.1f}' cy='{1:.1f}' r='12' fill='{2}'/><text x='{0:.1f}' y='{3:.1f}' "
      "text-anchor='middle' fill='#ffffff' font-size='11'>{4:02}</text>\n",
      p.x, p.y, colour, p.y + 4, row.record.prn);
}

}  // namespace

std::string sky_plot_svg(const SkyListing& listing) {
  std::string svg =
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 640 680' font-family='sans-serif' "
      "font-size='14'>\n<rect width='640' height='680' fill='#ffffff'/>\n";
  svg += grid();
  std::string ways, satellites;
  for (const SkyRow& row : listing.rows) {
    if (row.look->elevation_rad < 0) continue;
    ways += way(listing, row);
    satellites += satellite(row);
  }
  return svg + ways + satellites +
         fmt::format(
             "<text x='{}' y='640' text-anchor='middle'>{}, from {:.4f}°, {:.4f}°, "
             "{:.0f} m</text>\n<text x='{}' y='662' text-anchor='middle' fill='#777777' "
             "font-size='12'>blue: healthy, red: unhealthy; lines: the last hour</text>\n"
             "</svg>\n",
             middle, to_string(listing.at), listing.from->latitude_rad / units::degree,
             listing.from->longitude_rad / units::degree, listing.from->height_m, middle);
}

}  // namespace drydock::world

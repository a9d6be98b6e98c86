#include "hil/summary/navigation_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hil/report/html.hpp"
#include "hil/summary/or_none.hpp"

namespace drydock::summary {
namespace {

std::string navigation_table(const NavigationError& e) {
  return fmt::format(
      "<div class=scroll><table><tr><th>error against truth<th>RMS<th>max<th>end</tr>\n"
      "<tr><td>horizontal position<td>{}<td>{}<td>{}</tr>\n"
      "<tr><td>depth<td>{}<td><td></tr>\n"
      "<tr><td>velocity over ground<td>{}<td>{}<td></tr>\n"
      "<tr><td>roll, pitch, heading<td>{}, {}, {}<td><td></tr>\n"
      "<tr><td>NEES of the horizontal position, per axis<td>{}<td><td></tr></table></div>\n",
      or_none(e.horizontal_rms_m, 2, " m"), or_none(e.horizontal_max_m, 2, " m"),
      or_none(e.horizontal_end_m, 2, " m"), or_none(e.depth_rms_m, 3, " m"),
      or_none(e.velocity_rms_mps, 4, " m/s"), or_none(e.velocity_max_mps, 4, " m/s"),
      or_none(e.roll_rms_deg, 5, "°"), or_none(e.pitch_rms_deg, 5, "°"),
      or_none(e.heading_rms_deg, 5, "°"), or_none(e.nees_position, 2));
}

/// The filter's 3-sigma band and the error over it. The first 2 % of the curve, where the band is
/// very wide, do not set the limit of the axis.
std::string error_figure(const std::string& title, const char* unit, const NavigationTrace& t,
                         const std::vector<double>& error, std::vector<double> sigma) {
  double largest = 0;
  for (std::size_t i = 0; i < error.size(); ++i) {
    sigma[i] *= 3;
    if (i > error.size() / 50) largest = std::max({largest, 1.3 * std::abs(error[i]), sigma[i]});
  }
  report::Figure plot{title, "time [s]", unit, {}};
  plot.y_limit = largest;
  plot.curves.push_back({"3 sigma", t.t_s, std::move(sigma), true});
  plot.curves.push_back({"estimate - truth", t.t_s, error});
  return report::html::figure(plot);
}

}  // namespace

std::string navigation_section(const std::optional<NavigationError>& error,
                               const NavigationTrace& t) {
  if (t.t_s.empty()) return {};
  std::string out = error ? navigation_table(*error) : "<p>No truth to compare with.</p>\n";
  report::Figure track{"Track: truth and estimate", "east [m]", "north [m]", {}};
  track.equal_scales = true;
  if (error) track.curves.push_back({"truth", t.true_east_m, t.true_north_m});
  track.curves.push_back({"estimate", t.east_m, t.north_m});
  out += report::html::figure(track);
  if (error) {
    out += error_figure("Position north: error with the filter's 3-sigma band", "m", t,
                        t.north_error_m, t.north_sigma_m);
    out += error_figure("Position east: error with the filter's 3-sigma band", "m", t,
                        t.east_error_m, t.east_sigma_m);
    constexpr std::array axes{"north", "east", "down"};
    for (std::size_t i = 0; i < 3; ++i)
      out += error_figure(fmt::format("Velocity {}: error with the filter's 3-sigma band", axes[i]),
                          "m/s", t, t.velocity_error_mps[i], t.velocity_sigma_mps[i]);
  }
  if (!t.current_north_mps.empty())
    out += report::html::figure(
        {"Current, as the filter has it",
         "time [s]",
         "m/s",
         {{"north", t.t_s, t.current_north_mps}, {"east", t.t_s, t.current_east_mps}}});
  return out;
}

}  // namespace drydock::summary

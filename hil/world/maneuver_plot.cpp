#include "hil/world/maneuver_plot.hpp"

#include "drivers/measurement/units.hpp"
#include "hil/report/plot.hpp"

namespace drydock::world {

namespace {

using namespace motion::element;

template <class Across, class Up>
report::Curve series(const std::string& label, const motion::Track& track, Across&& across,
                     Up&& up) {
  constexpr std::size_t enough = 2000;  // enough points for a smooth curve on a screen
  report::Curve made{label, {}, {}};
  for (std::size_t i = 0; i < track.size(); i += 1 + track.size() / enough) {
    made.x.push_back(across(track[i]));
    made.y.push_back(up(track[i]));
  }
  return made;
}

auto time_of(const motion::TrackPoint& point) { return point.t; }

auto state(int i, double unit = 1) {
  return [=](const motion::TrackPoint& point) { return point.state[i] * unit; };
}

auto surface(double hydrodynamics::Control::*which) {
  return [=](const motion::TrackPoint& point) {
    return point.control.*which * units::degrees_per_radian;
  };
}

report::Figure path_of(const motion::Track& track) {
  report::Figure plot{"Path", "east [m]", "north [m]", {}};
  plot.equal_scales = true;
  plot.curves = {series("path", track, state(y), state(x))};
  return plot;
}

report::Figure zigzag_of(const motion::Track& track) {
  report::Figure plot{"Zigzag", "time [s]", "[deg]", {}};
  plot.curves = {series("heading", track, time_of, state(yaw, units::degrees_per_radian)),
                 series("rudder", track, time_of, surface(&hydrodynamics::Control::delta_r))};
  return plot;
}

report::Figure spiral_of(const motion::Track& track) {
  report::Figure plot{"Direct spiral", "rudder [deg]", "rate of turn [deg/s]", {}};
  report::Curve there{"there", {}, {}}, back{"back", {}, {}};
  for (const auto& point : motion::spiral_points(track)) {
    report::Curve& way = point.returning ? back : there;
    way.x.push_back(point.rudder_rad * units::degrees_per_radian);
    way.y.push_back(point.rate_of_turn_radps * units::degrees_per_radian);
  }
  plot.curves = {there, back};
  return plot;
}

report::Figure dive_of(const motion::Track& track) {
  report::Figure plot{"Dive", "time [s]", "[deg], [m]", {}};
  plot.curves = {
      series("pitch [deg]", track, time_of, state(pitch, units::degrees_per_radian)),
      series("stern planes [deg]", track, time_of, surface(&hydrodynamics::Control::delta_s)),
      series("height over the start [m]", track, time_of, state(z, -1))};
  return plot;
}

report::Figure plot_of(std::optional<motion::ManeuverKind> kind, const motion::Track& track) {
  if (kind == motion::ManeuverKind::zigzag) return zigzag_of(track);
  if (kind == motion::ManeuverKind::spiral) return spiral_of(track);
  if (kind == motion::ManeuverKind::dive) return dive_of(track);
  return path_of(track);
}

}  // namespace

std::string plot_svg(std::optional<motion::ManeuverKind> kind, const motion::Track& track) {
  return report::render_svg(plot_of(kind, track));
}

}  // namespace drydock::world

#include "hil/world/maneuver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>

#include "drivers/measurement/units.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "hil/motion/maneuver/maneuver.hpp"
#include "hil/motion/schedule.hpp"
#include "hil/report/write_file.hpp"
#include "hil/world/maneuver_plot.hpp"
#include "rig_config/load.hpp"

namespace drydock::world {

namespace {

constexpr double usual_propeller_radps = 1500 * 2 * std::numbers::pi / 60;

std::optional<double> radians(const std::optional<double>& angle_deg) {
  return angle_deg ? std::optional(*angle_deg * units::degree) : std::nullopt;
}

motion::Schedule read_schedule(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw motion::BadSchedule(path + ": cannot be read");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return motion::parse_schedule(text, path);
}

/// The vehicle cannot sail the requested manoeuvre.
struct Refused : std::runtime_error {
  using runtime_error::runtime_error;
};

motion::Maneuver maneuver_of(const ManeuverOptions& options,
                             const rig_config::VehicleConfig& vehicle) {
  const double usual_mps = usual_propeller_radps * vehicle.propeller.advance_m;
  motion::Maneuver m;
  m.kind = *motion::maneuver_kind(options.kind);
  m.speed_mps = options.speed_mps.value_or(std::min(usual_mps, motion::fastest_mps(vehicle)));
  m.deflection_rad = radians(options.deflection_deg);
  if (options.switch_deg) m.switch_rad = *options.switch_deg * units::degree;
  return m;
}

motion::Track sail(const ManeuverOptions& options, const rig_config::VehicleConfig& vehicle) {
  if (options.schedule.empty()) {
    const auto m = maneuver_of(options, vehicle);
    if (const auto why_not = motion::refusal(vehicle, m)) throw Refused(*why_not);
    return motion::sail(vehicle, m);
  }
  constexpr double behind_last_row_s = 300;
  const double advance = vehicle.propeller.advance_m;
  const auto schedule = read_schedule(options.schedule);
  const double speed = options.speed_mps.value_or(schedule.front().propeller_radps * advance);
  const auto until = options.duration_s.value_or(schedule.back().t + behind_last_row_s);
  return motion::sail(vehicle, speed, until, [&](double t, const auto&) {
    return std::optional(motion::command_at(schedule, t, advance));
  });
}

std::string csv_of(const motion::Track& track) {
  std::string out = "t,u,v,w,p,q,r,x,y,z,phi,theta,psi,delta_r,delta_s,delta_b\n";
  constexpr std::size_t each = 5;  // one of 5 points: 50 Hz becomes 10 Hz
  for (std::size_t i = 0; i < track.size(); i += each) {
    const auto& point = track[i];
    out += fmt::format("{:.10g}", point.t);
    for (const double value : point.state) out += fmt::format(",{:.10g}", value);
    out += fmt::format(",{:.10g},{:.10g},{:.10g}\n", point.control.delta_r, point.control.delta_s,
                       point.control.delta_b);
  }
  return out;
}

/// "tactical diameter", "m" -> "tactical_diameter_m"
std::string key_of(const motion::Figure& figure) {
  std::string key = figure.name + "_" + figure.unit;
  for (char& c : key)
    if (c == ' ') c = '_';
  std::erase(key, ',');
  const auto per = key.find("/s");
  if (per != key.npos) key.replace(per, 2, "ps");
  const auto percent = key.find('%');
  if (percent != key.npos) key.replace(percent, 1, "percent");
  return key;
}

nlohmann::ordered_json to_json(const std::vector<motion::Figure>& figures,
                               const std::vector<motion::SpiralPoint>& points,
                               const motion::Track& track) {
  nlohmann::ordered_json json;
  json["duration_s"] = track.back().t;
  for (const auto& figure : figures)
    json[key_of(figure)] = figure.value ? nlohmann::ordered_json(*figure.value) : nullptr;
  for (const auto& point : points)
    json["spiral"].push_back({{"rudder_deg", point.rudder_rad / units::degree},
                              {"rate_of_turn_degps", point.rate_of_turn_radps / units::degree},
                              {"returning", point.returning}});
  return json;
}

void print_table(std::FILE* out, const std::vector<motion::Figure>& figures,
                 const std::vector<motion::SpiralPoint>& points, const motion::Track& track) {
  const auto line = [&](const std::string& name, const std::string& value,
                        const std::string& unit) {
    fmt::print(out, "{:<40} {:>10} {}\n", name, value, unit);
  };
  for (const auto& f : figures)
    line(f.name, f.value ? fmt::format("{:.3f}", *f.value) : "not reached", f.value ? f.unit : "");
  if (!points.empty()) fmt::print(out, "{:>14} {:>22}\n", "rudder [deg]", "rate of turn [deg/s]");
  for (const auto& p : points)
    fmt::print(out, "{:>+14.2f} {:>+22.4f}{}\n", p.rudder_rad / units::degree,
               p.rate_of_turn_radps / units::degree, p.returning ? "  returning" : "");
  line("duration", fmt::format("{:.1f}", track.back().t), "s");
  line("deepest",
       fmt::format("{:.3f}",
                   std::ranges::max(
                       track, {}, [](const auto& point) { return point.state[motion::element::z]; })
                       .state[motion::element::z]),
       "m below the start");
}

/// One file that fails does not keep the other from being written.
int write(const std::string& path, const std::string& text, std::FILE* errors) try {
  report::write_file(path, text);
  return terminal::exit_success;
} catch (const std::runtime_error& error) {
  fmt::print(errors, "maneuver: {}\n", error.what());
  return terminal::exit_failed;
}

int write_plot(const std::string& path, const std::string& svg, std::FILE* errors) {
  if (!svg.empty()) return write(path, svg, errors);
  fmt::print(errors, "maneuver: {}: gnuplot is needed and missing\n", path);
  return terminal::exit_failed;
}

}  // namespace

int maneuver(const ManeuverOptions& options, std::FILE* out, std::FILE* errors) {
  auto loaded = rig_config::load_vehicle(options.vehicle);
  if (!loaded) {
    for (const auto& problem : loaded.error()) fmt::print(errors, "{}\n", to_string(problem));
    return terminal::exit_usage;
  }
  const auto kind = motion::maneuver_kind(options.kind);
  motion::Track track;
  try {
    track =
        sail(options, options.ideal_actuators ? motion::with_ideal_actuators(*loaded) : *loaded);
  } catch (const motion::BadSchedule& bad) {
    fmt::print(errors, "{}\n", bad.what());
    return terminal::exit_usage;
  } catch (const Refused& refused) {
    fmt::print(errors, "maneuver: {}: {}\n", options.vehicle, refused.what());
    return terminal::exit_usage;
  }
  if (motion::too_steep(track.back().state))
    fmt::print(errors, "maneuver: ended after {:.1f} s: pitch came to {:.1f} deg\n", track.back().t,
               track.back().state[motion::element::pitch] / units::degree);
  const auto figures = kind ? motion::figures(*kind, track) : std::vector<motion::Figure>{};
  const auto points = kind == motion::ManeuverKind::spiral ? motion::spiral_points(track)
                                                           : std::vector<motion::SpiralPoint>{};
  if (options.json) {
    fmt::print(out, "{}\n", text::json_of_any_text(to_json(figures, points, track)));
  } else {
    print_table(out, figures, points, track);
  }
  int failed = 0;
  if (!options.csv.empty()) failed |= write(options.csv, csv_of(track), errors);
  if (!options.plot.empty()) failed |= write_plot(options.plot, plot_svg(kind, track), errors);
  return failed;
}

}  // namespace drydock::world

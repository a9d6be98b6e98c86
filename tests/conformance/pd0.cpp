#include <algorithm>
#include <array>
#include <cmath>

#include "tests/conformance/comparers.hpp"
#include "tests/conformance/reading.hpp"
#include "tests/conformance/scan.hpp"

/// Compares Teledyne PD0 with MHKiT-Python: one row for each ensemble, float32, for the first
/// ensembles of each file or all. A scan of checksums counts the others.
namespace drydock::conformance {

namespace {

using measurement::BottomVelocity;

constexpr Rule number_rule{
    "MHKiT ensemble number",
    "MHKiT counts LSW + 65535 * MSB, the instrument LSW + 65536 * MSB (ensembles beyond 65535)"};
constexpr Rule declination_rule{
    "MHKiT declination",
    "MHKiT adds the declination of the userdata.json beside the capture to the wire's heading"};
constexpr Rule pressure_rule{
    "MHKiT unsigned pressure",
    "MHKiT reads the pressure unsigned, so one just below zero comes out as 4294967 dbar"};

constexpr Rule no_sensor_rule{
    "pressure without a sensor",
    "the head says that it has no pressure sensor (sensors available, bit 5), and the reference "
    "gives the number that stands in its place"};

/// A scalar of a row. Our value in its unit is ours * scale + offset.
struct Column {
  const char* theirs;
  const char* ours;
  double scale, offset, resolution;
};
constexpr std::array ensemble_columns{
    Column{"time", "clock_s", 1, 0, 0.01},
    Column{"pitch", "pitch_deg", 1, 0, 0.01},
    Column{"roll", "roll_deg", 1, 0, 0.01},
    Column{"temp", "temperature_k", 1, -273.15, 0.01},
    Column{"c_sound", "sound_speed_mps", 1, 0, 1},
    Column{"depth", "depth_m", 1, 0, 0.1},
    Column{"salinity", "salinity_ppt", 1, 0, 1},
};

/// One value for each beam. MHKiT uses `bad` for a missing value.
struct BeamColumn {
  const char* theirs;
  const char* ours;
  double scale, resolution, bad;
};
constexpr double no_mark = -1e9;
constexpr std::array beam_columns{
    BeamColumn{"vel_bt", "bottom_velocity_mps", -1, 0.001, -32.768},
    BeamColumn{"dist_bt", "bottom_range_m", 1, 0.01, 0},
    BeamColumn{"corr_bt", "bottom_correlation", 1, 1, no_mark},
    BeamColumn{"amp_bt", "bottom_amplitude", 1, 1, no_mark},
    BeamColumn{"prcnt_gd_bt", "bottom_percent_good", 1, 1, no_mark},
};

json scaled(const json& value, double scale, double offset = 0) {
  return value.is_number() ? json(value.get<double>() * scale + offset) : json();
}

json marked(const json& value, double bad) {
  return value.is_number() && std::abs(value.get<double>() - bad) < 1e-4 ? json() : value;
}

Step float32(double resolution) { return {resolution, float32_rounding}; }

/// The step of a float32 of this size.
Step float32_of(double value) { return {value * float32_rounding}; }

/// MHKiT's number is too small by the MSB of the 24-bit ensemble number.
bool same_ensemble(const json& ours, const json& theirs) {
  const auto number = ours["ensemble"].get<std::uint32_t>();
  return theirs == number || theirs == number - (number >> 16);
}

void compare_heading(const json& ours, const json& row, double declination, Comparison& c) {
  json heading = scaled(ours["heading_deg"], 1, declination);
  if (declination != 0) c.by_rule(declination_rule);
  const json& theirs = row.at("heading");
  if (heading.is_number() && theirs.is_number())  // either side may wrap
    heading =
        theirs.get<double>() + std::remainder(heading.get<double>() - theirs.get<double>(), 360.0);
  c.number("heading", heading, theirs, float32(0.01));
}

void compare_pressure(const json& ours, const json& row, Comparison& c) {
  constexpr double turn_dbar = 4294967.296, dbar_per_pa = 1e-4;
  constexpr unsigned has_pressure_sensor = 1 << 5;
  const bool without_sensor =
      (ours["sensors_available"].get<unsigned>() & has_pressure_sensor) == 0;
  if (without_sensor && ours["pressure_pa"].is_null()) return c.by_rule(no_sensor_rule);
  json pressure = scaled(ours["pressure_pa"], dbar_per_pa);
  if (pressure.is_number() && pressure < 0 && row.at("pressure") > turn_dbar / 2) {
    c.by_rule(pressure_rule);
    c.number("pressure as unsigned", pressure.get<double>() + turn_dbar, row.at("pressure"),
             float32_of(turn_dbar));
    return;
  }
  c.number("pressure", pressure, row.at("pressure"), float32(0.001));
}

/// Compares the codec's message with the row.
void compare_message(const json& ours, const json& row, double declination, Comparison& c) {
  if (row.at("number") != ours["ensemble"]) c.by_rule(number_rule);
  if (row.contains("heading")) compare_heading(ours, row, declination, c);
  if (row.contains("pressure")) compare_pressure(ours, row, c);
  for (const Column& column : ensemble_columns) {
    if (!row.contains(column.theirs)) continue;
    c.number(column.theirs, scaled(ours[column.ours], column.scale, column.offset),
             row[column.theirs], float32(column.resolution));
  }
  for (const BeamColumn& column : beam_columns) {
    if (!row.contains(column.theirs)) continue;
    for (std::size_t beam = 0; beam < row[column.theirs].size() && beam < 4; ++beam)
      c.number(column.theirs,
               ours["bottom_track"] == true ? scaled(ours[column.ours][beam], column.scale)
                                            : json("no bottom track"),
               marked(row[column.theirs][beam], column.bad), float32(column.resolution));
  }
}

/// Compares the driver's measurement with the row: ranges, and the speed, which is equal in all
/// axes. What an upward-facing head measures in its own axes is not of the bed.
void compare_measurement(const BottomVelocity& driven, const json& ours, const json& row,
                         Comparison& c) {
  const bool other_axes = ours["frame"] != "ship" && ours["frame"] != "earth";
  if (!row.contains("vel_bt") || (ours["faces_up"] == true && other_axes)) return;
  for (std::size_t beam = 0; beam < 4; ++beam)
    c.number("driver range", optional(driven.range_m[beam]), marked(row.at("dist_bt")[beam], 0),
             float32(0.01));
  if (ours["frame"] == "beam") return;
  std::array<json, 3> v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = marked(row.at("vel_bt")[i], -32.768);
  const bool lock = std::ranges::all_of(v, [](const json& x) { return x.is_number(); });
  c.number("driver speed", driven.velocity ? json(driven.velocity->norm()) : json(),
           lock ? json(std::hypot(double(v[0]), double(v[1]), double(v[2]))) : json(),
           float32(0.001));
}

double declination_beside(const fs::path& capture) {
  const fs::path file = capture.parent_path() / (capture.stem().string() + ".userdata.json");
  if (!fs::exists(file)) return 0;
  return json::parse(read_text(file)).value("declination", 0.0);
}

}  // namespace

std::vector<Case> discover_pd0(const fs::path& folder) {
  auto captures = files_of(folder / "raw");
  std::erase_if(captures, [](const fs::path& file) { return file.extension() == ".json"; });
  return paired(captures, files_of(folder / "expected", ".jsonl"), [&](const fs::path& capture) {
    return folder / "expected" / (capture.stem().string() + ".jsonl");
  });
}

void compare_pd0(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string(), bytes = read_text(one.capture);
  const auto ours = decode("pd0", one.capture).messages;
  const auto driven = all_of<BottomVelocity>(drive(device::Kind::dvl, "pd0", bytes));
  const std::size_t sound = scan_pd0(bytes).size();
  const auto rows = one.expected.empty() ? std::vector<json>{} : read_json_lines(one.expected);
  const double declination = declination_beside(one.capture);

  std::size_t at = 0, with_bottom_track = 0, compared = 0;
  const auto measures = [](const json& m) {
    return m["bottom_track"] == true || !m["fine_bottom_velocity_mps"][0].is_null();
  };
  for (const json& row : rows) {
    std::size_t found = at;
    while (found < ours.size() && !same_ensemble(ours[found], row.at("number"))) ++found;
    if (found == ours.size()) {
      score.missed(name, row.at("i").get<std::size_t>() + 1, "ensemble " + row.at("number").dump());
      continue;
    }
    for (; at < found; ++at) with_bottom_track += measures(ours[at]);
    Comparison c(name, row.at("i").get<std::size_t>() + 1);
    compare_message(ours[at], row, declination, c);
    if (measures(ours[at]) && with_bottom_track < driven.size())
      compare_measurement(driven[with_bottom_track], ours[at], row, c);
    score.add(c);
    ++compared;
    with_bottom_track += measures(ours[at++]);
  }
  const std::size_t decoded = std::min(ours.size(), sound);
  score.matched(decoded - std::min(decoded, compared));
  for (std::size_t i = ours.size(); i < sound; ++i) score.missed(name, i + 1, "a sound ensemble");
  for (std::size_t i = sound; i < ours.size(); ++i) score.unexpected(name, i + 1, "an ensemble");
  const auto expected_of_driver = static_cast<std::size_t>(std::ranges::count_if(ours, measures));
  if (driven.size() != expected_of_driver)
    score.error(name + ": the driver gave " + std::to_string(driven.size()) + " velocities for " +
                std::to_string(expected_of_driver) + " ensembles with bottom track");
}

}  // namespace drydock::conformance

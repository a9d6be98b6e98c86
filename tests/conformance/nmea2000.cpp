#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>

#include "tests/conformance/canboat_text.hpp"
#include "tests/conformance/comparers.hpp"
#include "tests/conformance/reading.hpp"

/// Compares NMEA 2000 with canboat's analyzer (-json -si -nv): the messages of the PGNs that
/// Drydock reads, in the order of each sender.
namespace drydock::conformance {

namespace {

constexpr Rule no_fix_rule{
    "canboat prints a position without a fix",
    "the method field says no fix; what then stands in the position is no position"};
constexpr Rule dilution_rule{
    "canboat prints a negative dilution",
    "0xFFFF in the signed field of a dilution of precision, which cannot be below zero"};

constexpr Rule cut_number_rule{"canboat reads a number that is cut short",
                               "the message ends within the residual of its last satellite; "
                               "canboat takes the bytes that there "
                               "are for the number"};

/// How canboat prints a value without -si: ours * scale + offset, to that resolution.
struct Shown {
  double resolution = 0, scale = 1, offset = 0;
};
constexpr Shown as_is{}, in_degrees{0.1, degree}, in_degrees_per_second{2e-6, degree},
    in_celsius{0.01, 1, -273.15}, in_bar{0.001, 1e-5};

/// Our value in canboat's unit is ours * scale.
struct Column {
  const char* theirs;
  const char* ours;
  double resolution, scale = 1;
  Shown shown = as_is;  ///< without -si, if otherwise
};

constexpr double rpm = 30 / std::numbers::pi;

constexpr std::array rudder{
    Column{"Instance", "instance", 1}, Column{"Direction Order", "direction_order", 1},
    Column{"Angle Order", "angle_order_rad", 1e-4}, Column{"Position", "position_rad", 1e-4}};
constexpr std::array engine{
    Column{"Instance", "instance", 1}, Column{"Speed", "speed_radps", 0.25, rpm},
    Column{"Boost Pressure", "boost_pressure_pa", 100}, Column{"Tilt/Trim", "tilt_percent", 1}};
constexpr std::array water_depth{Column{"SID", "sequence", 1}, Column{"Depth", "depth_m", 0.01},
                                 Column{"Offset", "offset_m", 0.001},
                                 Column{"Range", "maximum_range_m", 10}};
constexpr std::array gnss_position{Column{"SID", "sequence", 1},
                                   Column{"Latitude", "latitude_rad", 1e-7, degree},
                                   Column{"Longitude", "longitude_rad", 1e-7, degree},
                                   Column{"Altitude", "altitude_m", 1e-6},
                                   Column{"GNSS type", "system", 1},
                                   Column{"Method", "method", 1},
                                   Column{"Number of SVs", "satellites", 1},
                                   Column{"HDOP", "horizontal_dop", 0.01},
                                   Column{"PDOP", "position_dop", 0.01},
                                   Column{"Geoidal Separation", "geoid_height_m", 0.01}};
constexpr std::array temperature{
    Column{"SID", "sequence", 1}, Column{"Instance", "instance", 1}, Column{"Source", "kind", 1},
    Column{"Actual Temperature", "actual_k", 0.01}, Column{"Set Temperature", "set_k", 0.01}};
constexpr std::array pressure{Column{"SID", "sequence", 1}, Column{"Instance", "instance", 1},
                              Column{"Source", "kind", 1}, Column{"Pressure", "pressure_pa", 0.1}};
constexpr std::array address_claim{
    Column{"Unique Number", "identity_number", 1},
    Column{"Manufacturer Code", "manufacturer_code", 1},
    Column{"Device Instance Lower", "ecu_instance", 1},
    Column{"Device Instance Upper", "function_instance", 1},
    Column{"Device Function", "function", 1},
    Column{"Device Class", "vehicle_system", 1},
    Column{"System Instance", "vehicle_system_instance", 1},
    Column{"Industry Group", "industry_group", 1},
    Column{"Arbitrary address capable", "arbitrary_address_capable", 1}};
constexpr std::array request{Column{"PGN", "requested_pgn", 1}};

constexpr std::array heading{
    Column{"SID", "sequence", 1}, Column{"Heading", "heading_rad", 1e-4, 1, in_degrees},
    Column{"Deviation", "deviation_rad", 1e-4, 1, in_degrees},
    Column{"Variation", "variation_rad", 1e-4, 1, in_degrees}, Column{"Reference", "reference", 1}};
constexpr std::array rate_of_turn{Column{"SID", "sequence", 1},
                                  Column{"Rate", "rate_radps", 3.125e-8, 1, in_degrees_per_second}};
constexpr std::array heave{Column{"SID", "sequence", 1}, Column{"Heave", "heave_m", 0.01}};
constexpr std::array attitude{Column{"SID", "sequence", 1},
                              Column{"Yaw", "yaw_rad", 1e-4, 1, in_degrees},
                              Column{"Pitch", "pitch_rad", 1e-4, 1, in_degrees},
                              Column{"Roll", "roll_rad", 1e-4, 1, in_degrees}};
constexpr std::array variation{Column{"SID", "sequence", 1}, Column{"Source", "model", 1},
                               Column{"Age of service", "date_days", 1},
                               Column{"Variation", "variation_rad", 1e-4, 1, in_degrees}};
constexpr std::array speed{
    Column{"SID", "sequence", 1}, Column{"Speed Water Referenced", "water_mps", 0.01},
    Column{"Speed Ground Referenced", "ground_mps", 0.01},
    Column{"Speed Water Referenced Type", "sensor", 1}, Column{"Speed Direction", "direction", 1}};
constexpr std::array distance_log{Column{"Log", "total_m", 1}, Column{"Trip Log", "trip_m", 1}};
constexpr std::array heading_control{
    Column{"Rudder Limit Exceeded", "rudder_limit_exceeded", 1},
    Column{"Off-Heading Limit Exceeded", "off_heading_limit_exceeded", 1},
    Column{"Off-Track Limit Exceeded", "off_track_limit_exceeded", 1},
    Column{"Override", "override_active", 1},
    Column{"Steering Mode", "steering_mode", 1},
    Column{"Turn Mode", "turn_mode", 1},
    Column{"Heading Reference", "reference", 1},
    Column{"Commanded Rudder Direction", "commanded_rudder_direction", 1},
    Column{"Commanded Rudder Angle", "commanded_rudder_rad", 1e-4},
    Column{"Heading-To-Steer (Course)", "heading_to_steer_rad", 1e-4},
    Column{"Track", "track_rad", 1e-4},
    Column{"Rudder Limit", "rudder_limit_rad", 1e-4},
    Column{"Off-Heading Limit", "off_heading_limit_rad", 1e-4},
    Column{"Radius of Turn Order", "turn_radius_m", 1},
    Column{"Rate of Turn Order", "commanded_rate_radps", 3.125e-5},
    Column{"Off-Track Limit", "off_track_limit_m", 1},
    Column{"Vessel Heading", "heading_rad", 1e-4}};
constexpr std::array rapid_position{Column{"Latitude", "latitude_rad", 1e-7, degree},
                                    Column{"Longitude", "longitude_rad", 1e-7, degree}};
constexpr std::array course_and_speed{
    Column{"SID", "sequence", 1}, Column{"COG Reference", "reference", 1},
    Column{"COG", "course_rad", 1e-4, 1, in_degrees}, Column{"SOG", "speed_mps", 0.01}};
constexpr std::array dilutions{Column{"SID", "sequence", 1},
                               Column{"Desired Mode", "desired_mode", 1},
                               Column{"Actual Mode", "actual_mode", 1},
                               Column{"HDOP", "horizontal_dop", 0.01},
                               Column{"VDOP", "vertical_dop", 0.01},
                               Column{"TDOP", "time_dop", 0.01}};
constexpr std::array satellites_in_view{Column{"SID", "sequence", 1},
                                        Column{"Range Residual Mode", "residual_mode", 1},
                                        Column{"Sats in View", "in_view", 1}};
constexpr std::array satellite{Column{"PRN", "number", 1},
                               Column{"Elevation", "elevation_rad", 1e-4, 1, in_degrees},
                               Column{"Azimuth", "azimuth_rad", 1e-4, 1, in_degrees},
                               Column{"SNR", "snr_db", 0.01},
                               Column{"Range residuals", "residual_m", 1e-5},
                               Column{"Status", "status", 1},
                               Column{"GNSS System", "system", 1}};
constexpr std::array water_and_air{
    Column{"SID", "sequence", 1}, Column{"Water Temperature", "water_k", 0.01, 1, in_celsius},
    Column{"Outside Ambient Air Temperature", "air_k", 0.01, 1, in_celsius},
    Column{"Atmospheric Pressure", "air_pressure_pa", 100, 1, in_bar}};
constexpr std::array environment{Column{"SID", "sequence", 1},
                                 Column{"Temperature Source", "kind", 1},
                                 Column{"Humidity Source", "humidity_kind", 1},
                                 Column{"Temperature", "temperature_k", 0.01, 1, in_celsius},
                                 Column{"Humidity", "humidity_percent", 0.004},
                                 Column{"Atmospheric Pressure", "air_pressure_pa", 100, 1, in_bar}};
constexpr std::array system_time{Column{"SID", "sequence", 1}, Column{"Source", "clock", 1}};

/// A PGN that Drydock reads.
struct Message {
  std::uint32_t pgn;
  std::string_view type;
  std::span<const Column> columns;
};
constexpr std::array messages{
    Message{127245, "rudder", rudder},
    Message{127488, "engine", engine},
    Message{128267, "water_depth", water_depth},
    Message{129029, "gnss_position", gnss_position},
    Message{130312, "temperature", temperature},
    Message{130314, "pressure", pressure},
    Message{126992, "system_time", system_time},
    Message{127237, "heading_control", heading_control},
    Message{127250, "vessel_heading", heading},
    Message{127251, "turn_rate", rate_of_turn},
    Message{127252, "heave", heave},
    Message{127257, "attitude", attitude},
    Message{127258, "magnetic_variation", variation},
    Message{128259, "speed", speed},
    Message{128275, "distance_log", distance_log},
    Message{129025, "rapid_position", rapid_position},
    Message{129026, "course_and_speed", course_and_speed},
    Message{129539, "dilutions", dilutions},
    Message{129540, "satellites_in_view", satellites_in_view},
    Message{130310, "water_and_air", water_and_air},
    Message{130311, "environment", environment},
    Message{60928, "address_claimed", address_claim},
    Message{59904, "request", request},
};

const Message* message_of(const json& row) {
  const auto found = std::ranges::find(messages, row.value("pgn", 0U), &Message::pgn);
  return found == messages.end() ? nullptr : &*found;
}

/// canboat's value: plain, or beside its name or its bytes. Null if there is none. A value with
/// only a name is not compared.
json value_of(const json& fields, const char* key) {
  if (!fields.contains(key)) return nullptr;
  const json& field = fields[key];
  return field.is_object() ? field.value("value", json()) : field;
}

json in_their_unit(const json& value, double scale, double offset = 0) {
  if (value.is_boolean()) return int(value.get<bool>());
  return value.is_number() ? json(value.get<double>() * scale + offset) : value;
}

bool by_rule(const json& ours, const json& fields, const Column& column, Comparison& c) {
  const std::string_view key = column.theirs;
  const json theirs = value_of(fields, column.theirs);
  if (!ours[column.ours].is_null() || !theirs.is_number()) return false;
  if (key == "Range residuals" && !fields.contains("Status")) {
    c.by_rule(cut_number_rule);
    return true;
  }
  const bool position = key == "Latitude" || key == "Longitude" || key == "Altitude";
  if (position && value_of(fields, "Method") == 0) {
    c.by_rule(no_fix_rule);
    return true;
  }
  if (key.ends_with("DOP") && theirs < 0) {
    c.by_rule(dilution_rule);
    return true;
  }
  return false;
}

void compare_time(const json& ours, const json& fields, Comparison& c) {
  const json days = value_of(fields, "Date"), steps = value_of(fields, "Time");
  if (days.is_string() || steps.is_string()) return;
  const bool whole = days.is_number() && steps.is_number();
  c.number("UTC", ours["utc_ns"].is_number() ? json(double(ours["utc_ns"]) * 1e-9) : json(),
           whole ? json(double(days) * 86400 + double(steps) * 1e-4) : json(), {1e-4});
}

void compare_columns(const std::string& type, std::span<const Column> columns, const json& ours,
                     const json& fields, bool si, Comparison& c) {
  for (const Column& column : columns) {
    const json theirs = value_of(fields, column.theirs);
    if (theirs.is_string() || by_rule(ours, fields, column, c)) continue;
    const bool shown = !si && column.shown.resolution > 0;
    const auto& [resolution, scale, offset] = column.shown;
    c.number(type + " " + column.theirs,
             shown ? in_their_unit(ours[column.ours], scale, offset)
                   : in_their_unit(ours[column.ours], column.scale),
             theirs, {shown ? resolution : column.resolution});
  }
}

void compare_satellites(const json& ours, const json& fields, bool si, Comparison& c) {
  const json& theirs = fields.contains("list") ? fields["list"] : json::array();
  c.same("satellites", ours.size(), theirs.size());
  for (std::size_t i = 0; i < std::min(ours.size(), theirs.size()); ++i)
    compare_columns("satellite", satellite, ours[i], theirs[i], si, c);
}

void compare_message(const json& ours, const json& row, const Message& message, bool si,
                     Comparison& c) {
  c.same("source", ours["source"], row.at("src"));
  // canboat leaves the fields out if no value of the message is available.
  static const json no_fields = json::object();
  const json& fields = row.contains("fields") ? row.at("fields") : no_fields;
  compare_columns(std::string(message.type), message.columns, ours, fields, si, c);
  if (ours.contains("utc_ns")) compare_time(ours, fields, c);
  if (message.type == "satellites_in_view") compare_satellites(ours["satellites"], fields, si, c);
}

/// The first line of canboat's output names its units; older outputs have none, and are not SI.
bool in_si(const std::vector<json>& rows) {
  return !rows.empty() && rows[0].value("units", "") == "si";
}

using Queues = std::map<std::pair<std::string, int>, std::deque<json>>;

Queues by_sender(std::vector<json> decoded) {
  Queues queues;
  for (json& message : decoded) {
    const std::pair key{message["type"].get<std::string>(), message["source"].get<int>()};
    queues[key].push_back(std::move(message));
  }
  return queues;
}

void compare_rows(const std::string& name, std::vector<json> decoded, const std::vector<json>& rows,
                  Score& score) {
  Queues queues = by_sender(std::move(decoded));
  const bool si = in_si(rows);
  std::size_t number = 0;
  for (const json& row : rows) {
    const Message* message = message_of(row);
    if (row.contains("pgn")) ++number;
    if (!message) continue;
    auto& queue = queues[{std::string(message->type), row.at("src").get<int>()}];
    if (queue.empty()) {
      score.missed(name, number, row.dump());
      continue;
    }
    Comparison c(name, number);
    compare_message(queue.front(), row, *message, si, c);
    score.add(c);
    queue.pop_front();
  }
  for (const auto& [key, queue] : queues)
    for (const json& left : queue) score.unexpected(name, 0, left.dump());
}

/// STEM.in and its golden output with values in numbers: the STEM*.out with nv in its name,
/// otherwise STEM.out if it is JSON.
fs::path golden_beside(const fs::path& input) {
  const std::string stem = (input.parent_path() / input.stem()).string();
  for (const char* end : {"-json-nv.out", "-nv.out", ".out"})
    if (fs::exists(stem + end) && read_text(stem + end).starts_with("{")) return stem + end;
  return {};
}

}  // namespace

std::vector<Case> discover_canboat_samples(const fs::path& folder) {
  auto expected = files_of(folder / "expected", ".json");
  return paired(files_of(folder / "samples"), expected, [&](const fs::path& sample) {
    return folder / "expected" / (sample.filename().string() + ".json");
  });
}

void compare_canboat_sample(const Case& one, Score& score) {
  auto decoded = decode("nmea2000", one.capture).messages;
  if (one.expected.empty()) return score.matched(decoded.size());
  compare_rows(one.capture.filename().string(), std::move(decoded), read_json_lines(one.expected),
               score);
}

std::vector<Case> discover_canboat_tests(const fs::path& folder) {
  return paired(files_of(folder, ".in"), {}, golden_beside);
}

void compare_canboat_test(const Case& one, Score& score) {
  auto decoded = decode_bytes("nmea2000", candump_of(read_text(one.capture))).messages;
  if (one.expected.empty()) return score.matched(decoded.size());
  compare_rows(one.capture.filename().string(), std::move(decoded), read_json_lines(one.expected),
               score);
}

}  // namespace drydock::conformance

#include <array>

#include "drivers/wire/dvl/json_reader.hpp"
#include "drivers/wire/dvl/water_linked_json.hpp"
#include "drivers/wire/text_fields.hpp"

/// Decodes valid frames to messages. water_linked_json.cpp finds the frames.
namespace drydock::wire {
namespace {

using namespace water_linked_json;
using JsonMessage = std::optional<WaterLinkedJson::Message>;

/// How to read the value of one key.
template <class M>
struct Member {
  std::string_view key;
  void (*read)(JsonReader& json, M& into);
};

/// Reads an object. Keys that the table does not have are passed over.
template <class M, std::size_t n>
void read_members(JsonReader& json, M& into, const std::array<Member<M>, n>& table) {
  json.object([&](std::string_view key) {
    for (const auto& member : table)
      if (member.key == key) return member.read(json, into);
    json.skip();
  });
}

/// Unix time or time since boot. A larger one is none.
std::optional<std::chrono::microseconds> clock_time(JsonReader& json) {
  const auto value = json.number();
  if (!value || *value < 0 || *value > 9e15) return std::nullopt;
  return std::chrono::microseconds{static_cast<std::int64_t>(*value)};
}

std::optional<int> whole_number(JsonReader& json) {
  const auto value = json.number();
  if (!value || *value < -1e9 || *value > 1e9) return std::nullopt;
  return static_cast<int>(*value);
}

/// A length below 0 means that there is none.
std::optional<double> length(JsonReader& json) {
  const auto value = json.number();
  return value && *value >= 0 ? value : std::nullopt;
}

std::optional<double> angle(JsonReader& json) {
  const auto degrees = json.number();
  return degrees ? std::optional{radians(*degrees)} : std::nullopt;
}

bool is_true(JsonReader& json) { return json.boolean().value_or(false); }

constexpr std::array<Member<Transducer>, 6> of_transducer{{
    {"id", [](JsonReader& json, Transducer& m) { m.id = whole_number(json); }},
    {"velocity", [](JsonReader& json, Transducer& m) { m.velocity_mps = json.number(); }},
    {"distance", [](JsonReader& json, Transducer& m) { m.distance_m = length(json); }},
    {"rssi", [](JsonReader& json, Transducer& m) { m.rssi_dbm = json.number(); }},
    {"nsd", [](JsonReader& json, Transducer& m) { m.noise_dbm = json.number(); }},
    {"beam_valid", [](JsonReader& json, Transducer& m) { m.valid = is_true(json); }},
}};

void read_transducers(JsonReader& json, VelocityReport& m) {
  std::size_t i = 0;
  json.array([&] {
    Transducer one;
    read_members(json, one, of_transducer);
    if (!one.valid) one.velocity_mps.reset(), one.distance_m.reset();
    if (i < m.transducers.size()) m.transducers[i++] = one;
  });
}

/// Three rows of three. Anything else gives no covariance.
void read_covariance(JsonReader& json, VelocityReport& m) {
  std::size_t i = 0;
  json.array([&] {
    json.array([&] {
      const auto entry = json.number();
      if (i < m.covariance.size()) m.covariance[i] = entry;
      ++i;
    });
  });
  if (i != m.covariance.size()) m.covariance = {};
}

constexpr std::array<Member<VelocityReport>, 13> of_velocity{{
    {"time",
     [](JsonReader& json, VelocityReport& m) { m.interval_s = scaled(json.number(), 1e-3); }},
    {"vx", [](JsonReader& json, VelocityReport& m) { m.velocity_mps[0] = json.number(); }},
    {"vy", [](JsonReader& json, VelocityReport& m) { m.velocity_mps[1] = json.number(); }},
    {"vz", [](JsonReader& json, VelocityReport& m) { m.velocity_mps[2] = json.number(); }},
    {"fom", [](JsonReader& json, VelocityReport& m) { m.figure_of_merit_mps = json.number(); }},
    {"covariance", read_covariance},
    {"altitude", [](JsonReader& json, VelocityReport& m) { m.altitude_m = length(json); }},
    {"transducers", read_transducers},
    {"velocity_valid", [](JsonReader& json, VelocityReport& m) { m.valid = is_true(json); }},
    {"status", [](JsonReader& json,
                  VelocityReport& m) { m.hot = (whole_number(json).value_or(0) & 1) != 0; }},
    {"format", [](JsonReader& json, VelocityReport& m) { m.format = json.text(); }},
    {"time_of_validity",
     [](JsonReader& json, VelocityReport& m) { m.validity = clock_time(json); }},
    {"time_of_transmission",
     [](JsonReader& json, VelocityReport& m) { m.transmission = clock_time(json); }},
}};

constexpr std::array<Member<Position>, 10> of_position{{
    {"ts", [](JsonReader& json, Position& m) { m.time_s = json.number(); }},
    {"x", [](JsonReader& json, Position& m) { m.position_m[0] = json.number(); }},
    {"y", [](JsonReader& json, Position& m) { m.position_m[1] = json.number(); }},
    {"z", [](JsonReader& json, Position& m) { m.position_m[2] = json.number(); }},
    {"std", [](JsonReader& json, Position& m) { m.position_deviation_m = json.number(); }},
    {"roll", [](JsonReader& json, Position& m) { m.roll_rad = angle(json); }},
    {"pitch", [](JsonReader& json, Position& m) { m.pitch_rad = angle(json); }},
    {"yaw", [](JsonReader& json, Position& m) { m.yaw_rad = angle(json); }},
    {"status",
     [](JsonReader& json, Position& m) { m.trouble = whole_number(json).value_or(0) != 0; }},
    {"format", [](JsonReader& json, Position& m) { m.format = json.text(); }},
}};

constexpr std::array<Member<Response>, 5> of_response{{
    {"response_to", [](JsonReader& json, Response& m) { m.response_to = json.text(); }},
    {"success", [](JsonReader& json, Response& m) { m.success = is_true(json); }},
    {"error_message", [](JsonReader& json, Response& m) { m.error_message = json.text(); }},
    {"result", [](JsonReader& json, Response& m) { m.result = json.raw(); }},
    {"format", [](JsonReader& json, Response& m) { m.format = json.text(); }},
}};

constexpr std::array<Member<Command>, 2> of_command{{
    {"command", [](JsonReader& json, Command& m) { m.command = json.text(); }},
    {"parameters", [](JsonReader& json, Command& m) { m.parameters = json.raw(); }},
}};

constexpr std::array<Member<Configuration>, 7> of_configuration{{
    {"speed_of_sound",
     [](JsonReader& json, Configuration& m) { m.sound_speed_mps = json.number(); }},
    {"acoustic_enabled",
     [](JsonReader& json, Configuration& m) { m.acoustic_enabled = json.boolean(); }},
    {"dark_mode", [](JsonReader& json, Configuration& m) { m.dark_mode = json.boolean(); }},
    {"dark_mode_enabled", [](JsonReader& json, Configuration& m) { m.dark_mode = json.boolean(); }},
    {"mounting_rotation_offset",
     [](JsonReader& json, Configuration& m) { m.mounting_rotation_rad = angle(json); }},
    {"range_mode", [](JsonReader& json, Configuration& m) { m.range_mode = json.text(); }},
    {"periodic_cycling_enabled",
     [](JsonReader& json, Configuration& m) { m.periodic_cycling = json.boolean(); }},
}};

/// What tells the kind of an object, wherever it stands in it.
struct Marks {
  std::string_view type, format;
  bool has_velocity = false, is_command = false;
};

constexpr std::array<Member<Marks>, 4> of_any{{
    {"type", [](JsonReader& json, Marks& m) { m.type = json.text(); }},
    {"format", [](JsonReader& json, Marks& m) { m.format = json.text(); }},
    {"velocity_valid", [](JsonReader& json, Marks& m) { json.skip(), m.has_velocity = true; }},
    {"command", [](JsonReader& json, Marks& m) { json.skip(), m.is_command = true; }},
}};

template <class M>
JsonMessage read_velocity(JsonReader json) {
  M m;
  read_members<VelocityReport>(json, m, of_velocity);
  if (!m.valid) m.velocity_mps = {}, m.altitude_m.reset();
  return m;
}

template <class M, std::size_t n>
JsonMessage read_as(JsonReader json, const std::array<Member<M>, n>& table) {
  M m;
  read_members(json, m, table);
  return m;
}

JsonMessage read_marked(const Marks& marks, const JsonReader& json) {
  if (marks.type == Velocity::on_wire) return read_velocity<Velocity>(json);
  if (marks.type == WaterVelocity::on_wire) return read_velocity<WaterVelocity>(json);
  if (marks.type == Position::on_wire) return read_as(json, of_position);
  if (marks.type == Response::on_wire) return read_as(json, of_response);
  if (!marks.type.empty()) return Other{marks.type, marks.format};
  if (marks.has_velocity) return read_velocity<Velocity>(json);
  return marks.is_command ? read_as(json, of_command) : std::nullopt;
}

}  // namespace

std::optional<WaterLinkedJson::Message> WaterLinkedJson::decode(Bytes frame) {
  const JsonReader at_start(as_text(frame));
  JsonReader json = at_start;
  Marks marks;
  read_members(json, marks, of_any);
  return json.sound() ? read_marked(marks, at_start) : std::nullopt;
}

namespace water_linked_json {

std::optional<Configuration> read_configuration(std::string_view object) {
  if (!object.starts_with('{')) return std::nullopt;
  JsonReader json(object);
  Configuration m;
  read_members(json, m, of_configuration);
  return json.sound() ? std::optional{m} : std::nullopt;
}

}  // namespace water_linked_json
}  // namespace drydock::wire

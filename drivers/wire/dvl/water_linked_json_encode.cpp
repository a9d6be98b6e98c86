#include <array>

#include "drivers/wire/decimal_text.hpp"
#include "drivers/wire/dvl/water_linked_json.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::wire::water_linked_json {
namespace {

/// Writes compact JSON. Numbers have the digits of a measurement, not all of a double.
class JsonText {
 public:
  explicit JsonText(std::span<std::uint8_t> out) : out_(out) {}

  void open(std::string_view bracket) {
    separate();
    out_.text(bracket);
    first_ = true;
  }
  void close(std::string_view bracket) {
    out_.text(bracket);
    first_ = false;
  }
  /// The next value belongs to this key.
  void key(std::string_view key) {
    separate();
    quoted(key);
    out_.text(":");
    first_ = true;
  }

  void number(double value) {
    std::array<char, decimal_text_size> text;
    raw({text.data(), general_text(value, text.data())});
  }
  void raw(std::string_view value) {
    separate();
    out_.text(value);
  }
  void text(std::string_view value) {
    separate();
    quoted(value);
  }

  void member(std::string_view name, double value) {
    key(name);
    number(value);
  }
  void member(std::string_view name, int value) { member(name, static_cast<double>(value)); }
  void member(std::string_view name, bool value) {
    key(name);
    raw(value ? "true" : "false");
  }
  void member(std::string_view name, std::string_view value) {
    key(name);
    text(value);
  }
  /// A time has more digits than a measurement.
  void time(std::string_view name, double value, int decimals) {
    key(name);
    separate();
    out_.number(value, decimals);
  }
  void time(std::string_view name, const std::optional<std::chrono::microseconds>& value) {
    time(name, static_cast<double>(value.value_or(std::chrono::microseconds{0}).count()), 0);
  }

  std::size_t size() const { return out_.size(); }
  std::size_t end_line() {
    out_.text("\r\n");
    return out_.size();
  }

 private:
  void separate() {
    if (!first_) out_.text(",");
    first_ = false;
  }
  void quoted(std::string_view value) {
    out_.text("\"");
    out_.text(value);
    out_.text("\"");
  }

  FieldWriter out_;
  bool first_ = true;
};

constexpr double no_length = -1;

void write(JsonText& json, const Transducer& m) {
  json.open("{");
  json.member("id", m.id.value_or(0));
  json.member("velocity", m.velocity_mps.value_or(0));
  json.member("distance", m.distance_m.value_or(no_length));
  json.member("rssi", m.rssi_dbm.value_or(0));
  json.member("nsd", m.noise_dbm.value_or(0));
  json.member("beam_valid", m.valid);
  json.close("}");
}

void write(JsonText& json, const std::array<std::optional<double>, 9>& covariance) {
  json.key("covariance");
  json.open("[");
  for (std::size_t row = 0; row < 9; row += 3) {
    json.open("[");
    for (std::size_t i = row; i < row + 3; ++i) json.number(covariance[i].value_or(0));
    json.close("]");
  }
  json.close("]");
}

void write_velocity(JsonText& json, const VelocityReport& m) {
  constexpr std::array<std::string_view, 3> names{"vx", "vy", "vz"};
  for (std::size_t i = 0; i < names.size(); ++i)
    json.member(names[i], m.velocity_mps[i].value_or(0));
  json.member("fom", m.figure_of_merit_mps.value_or(0));
  write(json, m.covariance);
}

void write_transducers(JsonText& json, const VelocityReport& m) {
  json.key("transducers");
  json.open("[");
  for (const Transducer& transducer : m.transducers) write(json, transducer);
  json.close("]");
}

/// The keys of a real line in its order.
std::size_t encode(const VelocityReport& m, std::string_view type, std::span<std::uint8_t> out) {
  JsonText json{out};
  json.open("{");
  json.member("time", scaled(m.interval_s, 1e3).value_or(0));
  write_velocity(json, m);
  if (type == Velocity::on_wire) json.member("altitude", m.altitude_m.value_or(no_length));
  write_transducers(json, m);
  json.member("velocity_valid", m.valid);
  json.member("status", m.hot ? 1 : 0);
  json.member("format", m.format);
  json.member("type", type);
  json.time("time_of_validity", m.validity);
  json.time("time_of_transmission", m.transmission);
  json.close("}");
  return json.end_line();
}

}  // namespace

std::size_t encode(const Velocity& m, std::span<std::uint8_t> out) {
  return encode(m, Velocity::on_wire, out);
}

std::size_t encode(const WaterVelocity& m, std::span<std::uint8_t> out) {
  return encode(m, WaterVelocity::on_wire, out);
}

std::size_t encode(const Position& m, std::span<std::uint8_t> out) {
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  JsonText json{out};
  json.open("{");
  json.time("ts", m.time_s.value_or(0), 3);
  for (std::size_t i = 0; i < axes.size(); ++i) json.member(axes[i], m.position_m[i].value_or(0));
  json.member("std", m.position_deviation_m.value_or(0));
  json.member("roll", degrees(m.roll_rad).value_or(0));
  json.member("pitch", degrees(m.pitch_rad).value_or(0));
  json.member("yaw", degrees(m.yaw_rad).value_or(0));
  json.member("type", Position::on_wire);
  json.member("status", m.trouble ? 1 : 0);
  json.member("format", m.format);
  json.close("}");
  return json.end_line();
}

std::size_t encode(const Response& m, std::span<std::uint8_t> out) {
  JsonText json{out};
  json.open("{");
  json.member("response_to", m.response_to);
  json.member("success", m.success);
  json.member("error_message", m.error_message);
  json.key("result");
  json.raw(m.result.empty() ? "null" : m.result);
  json.member("format", m.format);
  json.member("type", Response::on_wire);
  json.close("}");
  return json.end_line();
}

std::size_t encode(const Command& m, std::span<std::uint8_t> out) {
  JsonText json{out};
  json.open("{");
  json.member("command", m.command);
  if (!m.parameters.empty()) {
    json.key("parameters");
    json.raw(m.parameters);
  }
  json.close("}");
  return json.end_line();
}

std::size_t encode_configuration(const Configuration& m, std::span<std::uint8_t> out) {
  JsonText json{out};
  json.open("{");
  if (m.sound_speed_mps) json.member("speed_of_sound", *m.sound_speed_mps);
  if (m.acoustic_enabled) json.member("acoustic_enabled", *m.acoustic_enabled);
  if (m.dark_mode) json.member("dark_mode_enabled", *m.dark_mode);
  if (m.mounting_rotation_rad)
    json.member("mounting_rotation_offset", degrees(*m.mounting_rotation_rad));
  if (!m.range_mode.empty()) json.member("range_mode", m.range_mode);
  if (m.periodic_cycling) json.member("periodic_cycling_enabled", *m.periodic_cycling);
  json.close("}");
  return json.size();
}

}  // namespace drydock::wire::water_linked_json

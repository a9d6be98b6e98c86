#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/dvl/water_linked_messages.hpp"

/// Messages of a Water Linked DVL over TCP (json_v1 to json_v3.3), and its commands. Axes: x
/// forward, y starboard, z down. Values have the meaning of the serial protocol's. Texts point into
/// the bytes that decode received and are as written: escapes are not resolved. `on_wire`: the type
/// that the object names.
namespace drydock::wire::water_linked_json {

using water_linked::Configuration;

/// Without an echo, velocity and distance are empty. Echo and noise are as sent: json_v1 gives them
/// without their sign.
struct Transducer {
  std::optional<int> id;  ///< from 0
  bool valid = false;
  std::optional<double> velocity_mps;  ///< along the beam, positive toward the bed
  std::optional<double> distance_m;    ///< along the beam
  std::optional<double> rssi_dbm, noise_dbm;
};

struct VelocityReport : water_linked::Report, water_linked::ReportTimes {
  std::optional<double> altitude_m;                 ///< vertical, not corrected for tilt
  std::array<std::optional<double>, 9> covariance;  ///< (m/s)2, by rows
  std::array<Transducer, 4> transducers;
  std::string_view format;  ///< json_v3.3
};

/// Over the bed. json_v1 has no type and no times; what has velocity_valid is one.
struct Velocity : VelocityReport {
  static constexpr std::string_view type = "json_velocity", on_wire = "velocity";
};

/// Through the water. It has no altitude.
struct WaterVelocity : VelocityReport {
  static constexpr std::string_view type = "json_velocity_water", on_wire = "velocity_water";
};

/// Dead reckoning: the way since the last reset, in the DVL's axes at that time.
struct Position : water_linked::DeadReckoning {
  static constexpr std::string_view type = "json_position_local", on_wire = "position_local";
  std::string_view format;
};

/// The answer to a command.
struct Response {
  static constexpr std::string_view type = "json_response", on_wire = "response";
  std::string_view response_to;  ///< empty: what came was no JSON
  bool success = false;
  std::string_view error_message;
  std::string_view result;  ///< JSON
  std::string_view format;
};

/// To the DVL.
struct Command {
  static constexpr std::string_view type = "json_command";
  std::string_view command;
  std::string_view parameters;  ///< JSON; empty: none
};

/// A report whose type these documents do not know.
struct Other {
  static constexpr std::string_view type = "json_other";
  std::string_view name;  ///< its type
  std::string_view format;
};

/// Reads the result of get_config, or the parameters of set_config. Empty if it is no object.
std::optional<Configuration> read_configuration(std::string_view object);

/// Each writes one line with CR LF, its keys in the order of the DVL's, and returns its size, 0 if
/// `out` is too small.
std::size_t encode(const Velocity& m, std::span<std::uint8_t> out);
std::size_t encode(const WaterVelocity& m, std::span<std::uint8_t> out);
std::size_t encode(const Position& m, std::span<std::uint8_t> out);
std::size_t encode(const Response& m, std::span<std::uint8_t> out);
std::size_t encode(const Command& m, std::span<std::uint8_t> out);
/// The object alone. An empty value is left out.
std::size_t encode_configuration(const Configuration& m, std::span<std::uint8_t> out);

template <class F>
void visit_fields(const Transducer& m, F&& field) {
  field("id", m.id);
  field("valid", m.valid);
  field("velocity_mps", m.velocity_mps);
  field("distance_m", m.distance_m);
  field("rssi_dbm", m.rssi_dbm);
  field("noise_dbm", m.noise_dbm);
}

template <class F>
void visit_fields(const VelocityReport& m, F&& field) {
  water_linked::visit_report(m, field);
  field("altitude_m", m.altitude_m);
  field("covariance_m2ps2", m.covariance);
  water_linked::visit_times(m, field);
  field("transducers", m.transducers);
  field("format", m.format);
}

template <class F>
void visit_fields(const Position& m, F&& field) {
  visit_fields(static_cast<const water_linked::DeadReckoning&>(m), field);
  field("format", m.format);
}

template <class F>
void visit_fields(const Response& m, F&& field) {
  field("response_to", m.response_to);
  field("success", m.success);
  field("error_message", m.error_message);
  field("result", m.result);
  field("format", m.format);
}

template <class F>
void visit_fields(const Command& m, F&& field) {
  field("command", m.command);
  field("parameters", m.parameters);
}

template <class F>
void visit_fields(const Other& m, F&& field) {
  field("name", m.name);
  field("format", m.format);
}

}  // namespace drydock::wire::water_linked_json

#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/fields.hpp"

/// Messages between a Water Linked DVL and its user (Water Linked, DVL serial protocol 2.7). Axes:
/// x forward, y starboard, z down. The velocities are those of the DVL. Texts point into the bytes
/// that decode received.
namespace drydock::wire::water_linked {

using Velocity = std::array<std::optional<double>, 3>;

/// Common part of the velocity reports. Without `valid`, velocities and altitude are empty.
struct Report {
  Velocity velocity_mps;
  bool valid = false;
  std::optional<double> figure_of_merit_mps;  ///< accuracy of the velocities
};

/// Times of the DVL's clock: Unix time, or time since boot if it was not set. Their difference is
/// the age of the report when it is sent: acoustic travel and processing.
struct ReportTimes {
  std::optional<std::chrono::microseconds> validity, transmission;
  /// Time since the previous report: an interval, not a clock.
  std::optional<double> interval_s;
  bool hot = false;  ///< thermal shutdown is near
};

/// wrz: over the bed. Firmware sends fewer than nine covariances if the velocity is not valid.
struct BottomVelocity : Report, ReportTimes {
  static constexpr std::string_view type = "wrz";
  std::optional<double> altitude_m;
  std::array<std::optional<double>, 9> covariance;  ///< (m/s)2, by rows
};

/// wrs: through the water. Another sentence has this name too: a time status. It has other fields
/// and gives no message.
struct WaterVelocity : Report, ReportTimes {
  static constexpr std::string_view type = "wrs";
  std::array<std::optional<double>, 9> covariance;
};

/// wrx: over the bed, from old firmware. The oldest firmware sends no status.
struct OldVelocity : Report {
  static constexpr std::string_view type = "wrx";
  std::optional<double> interval_s, altitude_m;
  std::optional<bool> hot;
};

/// wru: one transducer. Without an echo, distance and velocity are empty.
struct Transducer {
  static constexpr std::string_view type = "wru";
  int id = 0;                          ///< from 0
  std::optional<double> velocity_mps;  ///< along the beam
  std::optional<double> distance_m;    ///< along the beam
  std::optional<double> rssi_dbm, noise_dbm;
};

/// wrt: distances along the beams, from old firmware.
struct OldRanges {
  static constexpr std::string_view type = "wrt";
  std::array<std::optional<double>, 4> distance_m;
};

/// wrp: the distance since the last reset, in the DVL's axes at that time.
struct DeadReckoning {
  static constexpr std::string_view type = "wrp";
  std::optional<double> time_s;
  std::array<std::optional<double>, 3> position_m;
  std::optional<double> position_deviation_m;
  std::optional<double> roll_rad, pitch_rad, yaw_rad;
  bool trouble = false;
};

/// wrv, wrw: version of the protocol, and of the DVL.
struct Version {
  static constexpr std::string_view type = "wrv";
  int major = 0, minor = 0, patch = 0;
};
struct Product {
  static constexpr std::string_view type = "wrw";
  std::string_view name, version, chip_id, ip_address;
};

/// wrc. In a command wcs an empty value leaves the DVL's setting unchanged.
struct Configuration {
  static constexpr std::string_view type = "wrc";
  std::optional<double> sound_speed_mps, mounting_rotation_rad;
  std::optional<bool> acoustic_enabled, dark_mode;
  std::string_view range_mode;
  std::optional<bool> periodic_cycling;
};

enum class Verdict : std::uint8_t { done, refused, not_understood, bad_checksum };
std::string_view to_string(Verdict verdict);

/// wra, wrn, wr?, wr!
struct Answer {
  static constexpr std::string_view type = "wr";
  Verdict verdict = Verdict::done;
};

/// wc: v version, w product, s set, c configuration, r reset dead reckoning, x ping, g calibrate
/// gyro, p output protocol (0 none, 1 all, 2 PD6, 3 without wrx and wrt, 6 PD4).
struct Command {
  static constexpr std::string_view type = "wc";
  char letter = 'v';
  std::string_view options;  ///< after the first comma
  std::string_view name() const { return {&letter, 1}; }
};

/// Reads the options of wcs. Empty if there are too few or too many fields, or if one is malformed.
std::optional<Configuration> read_configuration(std::string_view options);

/// Each writes one line with CR LF and returns its size, 0 if `out` is too small.
std::size_t encode(const BottomVelocity& m, std::span<std::uint8_t> out);
std::size_t encode(const OldVelocity& m, std::span<std::uint8_t> out);
std::size_t encode(const Transducer& m, std::span<std::uint8_t> out);
std::size_t encode(const OldRanges& m, std::span<std::uint8_t> out);
std::size_t encode(const Version& m, std::span<std::uint8_t> out);
std::size_t encode(const Product& m, std::span<std::uint8_t> out);
std::size_t encode(const Configuration& m, std::span<std::uint8_t> out);
std::size_t encode(const Answer& m, std::span<std::uint8_t> out);
std::size_t encode(const Command& m, std::span<std::uint8_t> out);
/// wcs: an empty value leaves the DVL's setting unchanged.
std::size_t encode_settings(const Configuration& m, std::span<std::uint8_t> out);

template <class F>
void visit_report(const Report& m, F&& field) {
  field("velocity_mps", m.velocity_mps);
  field("valid", m.valid);
  field("figure_of_merit_mps", m.figure_of_merit_mps);
}

template <class F>
void visit_times(const ReportTimes& m, F&& field) {
  field("time_of_validity_s", seconds(m.validity));
  field("time_of_transmission_s", seconds(m.transmission));
  field("interval_s", m.interval_s);
  field("hot", m.hot);
}

template <class F>
void visit_fields(const BottomVelocity& m, F&& field) {
  visit_report(m, field);
  field("altitude_m", m.altitude_m);
  field("covariance_m2ps2", m.covariance);
  visit_times(m, field);
}

template <class F>
void visit_fields(const WaterVelocity& m, F&& field) {
  visit_report(m, field);
  field("covariance_m2ps2", m.covariance);
  visit_times(m, field);
}

template <class F>
void visit_fields(const OldVelocity& m, F&& field) {
  field("interval_s", m.interval_s);
  visit_report(m, field);
  field("altitude_m", m.altitude_m);
  field("hot", m.hot);
}

template <class F>
void visit_fields(const Transducer& m, F&& field) {
  field("id", m.id);
  field("velocity_mps", m.velocity_mps);
  field("distance_m", m.distance_m);
  field("rssi_dbm", m.rssi_dbm);
  field("noise_dbm", m.noise_dbm);
}

template <class F>
void visit_fields(const OldRanges& m, F&& field) {
  field("distance_m", m.distance_m);
}

template <class F>
void visit_fields(const DeadReckoning& m, F&& field) {
  field("time_s", m.time_s);
  field("position_m", m.position_m);
  field("position_deviation_m", m.position_deviation_m);
  field("roll_deg", degrees(m.roll_rad));
  field("pitch_deg", degrees(m.pitch_rad));
  field("yaw_deg", degrees(m.yaw_rad));
  field("trouble", m.trouble);
}

template <class F>
void visit_fields(const Version& m, F&& field) {
  field("major", m.major);
  field("minor", m.minor);
  field("patch", m.patch);
}

template <class F>
void visit_fields(const Product& m, F&& field) {
  field("name", m.name);
  field("version", m.version);
  field("chip_id", m.chip_id);
  field("ip_address", m.ip_address);
}

template <class F>
void visit_fields(const Configuration& m, F&& field) {
  field("sound_speed_mps", m.sound_speed_mps);
  field("mounting_rotation_deg", degrees(m.mounting_rotation_rad));
  field("acoustic_enabled", m.acoustic_enabled);
  field("dark_mode", m.dark_mode);
  field("range_mode", m.range_mode);
  field("periodic_cycling", m.periodic_cycling);
}

template <class F>
void visit_fields(const Answer& m, F&& field) {
  field("verdict", to_string(m.verdict));
}

template <class F>
void visit_fields(const Command& m, F&& field) {
  field("command", m.name());
  field("options", m.options);
}

}  // namespace drydock::wire::water_linked

#pragma once

#include <array>
#include <chrono>
#include <optional>
#include <string_view>
#include <variant>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/fields.hpp"

namespace drydock::wire {

/// Common part of all bottom track sentences of Nortek.
struct NortekTimes {
  /// Time from the trigger, and from the sentence's first byte, to the centre of the bottom echo.
  /// The second is negative, because the echo came earlier.
  std::optional<double> after_trigger_s, after_sentence_s;
};

/// PNORBT0 and PNORBT1: one beam.
struct NortekBeam : NortekTimes {
  static constexpr std::string_view type = "PNORBT0";
  std::optional<int> beam;  ///< from 1
  std::string_view date;    ///< six digits, as sent
  std::optional<std::chrono::nanoseconds> time_of_day;
  std::optional<double> velocity_mps, distance_m;  ///< along the beam; the distance is vertical
  std::optional<double> figure_of_merit_mps;
  std::optional<unsigned> status;
};

/// PNORBT3 and PNORBT4: speed and its direction.
struct NortekSpeed : NortekTimes {
  static constexpr std::string_view type = "PNORBT3";
  std::optional<double> speed_mps, direction_rad, figure_of_merit_mps, distance_m;
};

/// The vehicle's velocity along the DVL's axes: PNORBT6 and PNORBT7, and with the state of the
/// instrument PNORBT8 and PNORBT9.
struct NortekVelocity : NortekTimes {
  static constexpr std::string_view type = "PNORBT6";
  std::optional<double> ping_time_s;                  ///< Unix time
  std::array<std::optional<double>, 3> velocity_mps;  ///< x forward, y starboard, z down
  std::optional<double> figure_of_merit_mps;
  std::array<std::optional<double>, 4> distance_m;  ///< vertical, for each beam
  std::optional<double> battery_v, sound_speed_mps, temperature_k;
  std::optional<unsigned> status;
};

/// The same fields relative to the water: PNORWT3 and PNORWT4, PNORWT6 to PNORWT9. Distances are to
/// the water layer.
struct NortekWaterSpeed : NortekSpeed {
  static constexpr std::string_view type = "PNORWT3";
};
struct NortekWaterVelocity : NortekVelocity {
  static constexpr std::string_view type = "PNORWT6";
};

/// Bottom and water track sentences of Nortek DVLs, in the line format of NMEA 0183. Formats 1, 3,
/// 6 and 8 write NAME=value; formats 0, 4, 7 and 9 write only the value. The decoder accepts both
/// under every number. A missing value is -32.768 for a velocity, 0 for a distance, 10 for a figure
/// of merit.
struct Nortek {
  static constexpr std::string_view name = "nortek";
  static constexpr std::size_t max_frame = 1024;
  using Message =
      std::variant<NortekBeam, NortekSpeed, NortekVelocity, NortekWaterSpeed, NortekWaterVelocity>;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
};

/// Writes PNORBT9 (PNORWT9) if the state of the instrument is known, otherwise PNORBT7 (PNORWT7).
/// Returns the bytes written, 0 if `out` is too small.
std::size_t encode(const NortekVelocity& m, std::span<std::uint8_t> out);
std::size_t encode(const NortekWaterVelocity& m, std::span<std::uint8_t> out);

template <class F>
void visit_fields(const NortekBeam& m, F&& field) {
  field("beam", m.beam);
  field("date", m.date);
  field("time_of_day_s", seconds(m.time_of_day));
  field("after_trigger_s", m.after_trigger_s);
  field("after_sentence_s", m.after_sentence_s);
  field("velocity_mps", m.velocity_mps);
  field("figure_of_merit_mps", m.figure_of_merit_mps);
  field("distance_m", m.distance_m);
  field("status", m.status);
}

template <class F>
void visit_fields(const NortekSpeed& m, F&& field) {
  field("after_trigger_s", m.after_trigger_s);
  field("after_sentence_s", m.after_sentence_s);
  field("speed_mps", m.speed_mps);
  field("direction_deg", degrees(m.direction_rad));
  field("figure_of_merit_mps", m.figure_of_merit_mps);
  field("distance_m", m.distance_m);
}

template <class F>
void visit_fields(const NortekVelocity& m, F&& field) {
  field("ping_time_s", m.ping_time_s);
  field("after_trigger_s", m.after_trigger_s);
  field("after_sentence_s", m.after_sentence_s);
  field("velocity_mps", m.velocity_mps);
  field("figure_of_merit_mps", m.figure_of_merit_mps);
  field("distance_m", m.distance_m);
  field("battery_v", m.battery_v);
  field("sound_speed_mps", m.sound_speed_mps);
  field("temperature_k", m.temperature_k);
  field("status", m.status);
}

}  // namespace drydock::wire

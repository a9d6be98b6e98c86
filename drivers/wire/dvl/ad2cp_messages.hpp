#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

#include "drivers/wire/fields.hpp"

/// Messages of Nortek's AD2CP instruments. Sources: Nortek, Signature Integrator's Guide 2017 and
/// DVL manual 2017; fields and marks of missing values as measured in records of a DVL333.
namespace drydock::wire::ad2cp {

using Four = std::array<std::optional<double>, 4>;  ///< empty: the instrument gives no value

/// Four velocities, m/s, with what the instrument says about each. Without a velocity the times are
/// rubbish on the wire, so they are empty here.
struct Estimates {
  Four velocity_mps, figure_of_merit_mps;
  /// To the centre of the bottom's echo: from the trigger, and from the start of the output. The
  /// second is negative, because the echo came earlier.
  Four after_trigger_s, after_output_s;
  Four duration_s;  ///< of the estimate
};

/// What records of all instruments tell about themselves.
struct About {
  unsigned version = 0;  ///< of the record's layout
  std::uint32_t serial_number = 0;
  std::optional<std::chrono::microseconds> clock;  ///< the instrument's, since 1970, of the ping
  std::uint32_t error = 0, status = 0;             ///< bits, as sent
  std::optional<double> sound_speed_mps, temperature_k;
  std::optional<double>
      pressure_pa;  ///< the instrument takes an offset off: about 0 at the surface
};

/// Records 1B and 1D, formats DF21 and DF22.
struct Track : About {
  unsigned number_of_beams = 0;
  Four distance_m;  ///< vertical component of each beam's range, not corrected for tilt
  Estimates beams;  ///< along beams 1 to 4, positive towards the bed
  Estimates axes;   ///< X, Y, Z1 (beams 1 and 3), Z2 (2 and 4): the instrument's own motion
};

/// Over the bed.
struct BottomTrack : Track {
  static constexpr std::string_view type = "dvl_bottom_track";
};

/// Through the water of a layer.
struct WaterTrack : Track {
  static constexpr std::string_view type = "dvl_water_track";
};

enum class Axes : std::uint8_t { earth, instrument, beam, unknown };

/// Record 17: bottom track among the profiles of a Signature (DF20, and DF3 in files). No document
/// at hand tells the sign of its velocities and the unit of its figures of merit.
struct SignatureBottomTrack : About {
  static constexpr std::string_view type = "bottom_track";
  std::optional<double> heading_rad, pitch_rad, roll_rad;
  double battery_v = 0, ambiguity_velocity_mps = 0;
  std::uint32_t ensemble = 0;
  unsigned number_of_beams = 0;
  Axes axes = Axes::unknown;  ///< of the velocities
  Four velocity_mps, distance_m;
  std::array<std::optional<unsigned>, 4> figure_of_merit;
};

/// A sound record that is not decoded, under the name of its id.
struct Other {
  std::string_view type = "other";
  unsigned id = 0, family = 0;
  std::uint64_t data_bytes = 0;
};

constexpr std::string_view to_string(Axes axes) {
  constexpr std::array<std::string_view, 4> names{"earth", "instrument", "beam", "unknown"};
  return names[static_cast<std::size_t>(axes)];
}

template <class F>
void visit_about(const About& m, F&& field) {
  field("version", m.version);
  field("serial_number", m.serial_number);
  field("clock_s", seconds(m.clock));
  field("error", m.error);
  field("status", m.status);
  field("sound_speed_mps", m.sound_speed_mps);
  field("temperature_k", m.temperature_k);
  field("pressure_pa", m.pressure_pa);
}

template <class F>
void visit_fields(const Track& m, F&& field) {
  visit_about(m, field);
  field("number_of_beams", m.number_of_beams);
  field("beam_velocity_mps", m.beams.velocity_mps);
  field("beam_distance_m", m.distance_m);
  field("beam_figure_of_merit_mps", m.beams.figure_of_merit_mps);
  field("beam_after_trigger_s", m.beams.after_trigger_s);
  field("beam_after_output_s", m.beams.after_output_s);
  field("beam_duration_s", m.beams.duration_s);
  field("velocity_mps", m.axes.velocity_mps);
  field("figure_of_merit_mps", m.axes.figure_of_merit_mps);
  field("after_trigger_s", m.axes.after_trigger_s);
  field("after_output_s", m.axes.after_output_s);
  field("duration_s", m.axes.duration_s);
}

template <class F>
void visit_fields(const SignatureBottomTrack& m, F&& field) {
  visit_about(m, field);
  field("heading_deg", degrees(m.heading_rad));
  field("pitch_deg", degrees(m.pitch_rad));
  field("roll_deg", degrees(m.roll_rad));
  field("battery_v", m.battery_v);
  field("ambiguity_velocity_mps", m.ambiguity_velocity_mps);
  field("ensemble", m.ensemble);
  field("number_of_beams", m.number_of_beams);
  field("axes", to_string(m.axes));
  field("velocity_mps", m.velocity_mps);
  field("distance_m", m.distance_m);
  field("figure_of_merit", m.figure_of_merit);
}

template <class F>
void visit_fields(const Other& m, F&& field) {
  field("id", m.id);
  field("family", m.family);
  field("data_bytes", m.data_bytes);
}

}  // namespace drydock::wire::ad2cp

#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/dvl/dvl_frame.hpp"
#include "drivers/wire/dvl/pd0_vmdas.hpp"
#include "drivers/wire/dvl/pd0_winriver.hpp"
#include "drivers/wire/fields.hpp"

/// The content of one PD0 ensemble (Teledyne Pathfinder DVL Guide, P/N 95B-6116-00, tables 32 to
/// 47).
namespace drydock::wire {

/// Properties and settings of the instrument.
struct Pd0FixedLeader : DvlGeometry {
  std::uint8_t firmware_version = 0, firmware_revision = 0;
  std::optional<double> frequency_hz;  ///< nominal
  std::uint8_t beams = 4, cells = 0;
  std::uint16_t pings_per_ensemble = 0;
  double cell_length_m = 0, blank_m = 0;
  double heading_bias_rad = 0;
  std::uint8_t sensor_source = 0, sensors_available = 0;  ///< bits c d h p r s t, see EZ
};

/// Time, and readings of the instrument's own sensors.
struct Pd0VariableLeader : DvlAttitude {
  std::uint32_t ensemble = 0;
  std::optional<std::chrono::local_time<std::chrono::milliseconds>> clock;  ///< at the first ping
  std::uint16_t built_in_test = 0;                                          ///< 0: passed
  std::optional<double> sound_speed_mps;
  double depth_m = 0;       ///< from the instrument's sensor, otherwise as set
  double salinity_ppt = 0;  ///< as set
  std::optional<double> temperature_k;
  std::optional<double> pressure_pa;  ///< gauge; empty without a depth sensor
};

/// Motion over the bed. On the wire the bed moves and the instrument stands still. Here the sign is
/// reversed, so velocities are those of the vehicle.
struct Pd0BottomTrack {
  std::uint16_t pings_per_ensemble = 0;
  DvlComponents velocity_mps;  ///< in the frame of the fixed leader
  /// Vertical component of each beam's range, not corrected for tilt. Empty if no bottom was found.
  std::array<std::optional<double>, 4> range_m;
  std::array<std::uint8_t, 4> correlation{}, amplitude{}, percent_good{};
  std::optional<double> max_depth_m;  ///< tracking limit
  /// Relative to the water layer, with the sign and frame of the bed velocities. Empty without
  /// water track.
  DvlComponents water_velocity_mps;
  std::optional<double> layer_near_m, layer_far_m;  ///< vertical distance from the head
  std::array<std::uint8_t, 4> water_percent_good{};
};

/// Motion of the vehicle in steps of 0.01 mm/s, in the frame of the fixed leader. On the wire too
/// these velocities are those of the vehicle.
struct Pd0HighResolution {
  DvlComponents bottom_velocity_mps, bottom_distance_m;  ///< distance made good
  DvlComponents water_velocity_mps, water_distance_m;    ///< relative to the water layer
};

/// Distance to the bed in steps of 0.1 mm.
struct Pd0BottomRange {
  std::optional<double> slant_range_m, vertical_range_m;  ///< for all beams together
  std::optional<double> axis_difference_m;                ///< between the two planes of beams
  std::array<std::optional<double>, 4> beam_range_m;      ///< raw
};

/// Age of the centre of each beam's bottom echo when the ensemble's first byte is sent. Empty for a
/// bad beam.
struct Pd0Navigation {
  std::array<std::optional<std::chrono::microseconds>, 4> echo_age;
};

struct Pd0Ensemble {
  static constexpr std::string_view type = "PD0";
  Pd0FixedLeader fixed;
  Pd0VariableLeader variable;
  std::optional<Pd0BottomTrack> bottom_track;
  std::optional<Pd0HighResolution> high_resolution;
  std::optional<Pd0BottomRange> bottom_range;
  std::optional<Pd0Navigation> navigation;
  Pd0ComputerNavigation computer;  ///< only in files of VmDas and of REMUS vehicles
  WinRiverSentences winriver;      ///< only in files that WinRiver wrote; no DVL sends them
};

/// Age of the velocity when the first byte is sent: the mean of the good beams.
std::optional<std::chrono::microseconds> age_of(const Pd0Navigation& navigation);

/// Writes header, fixed leader (59 bytes), variable leader (65), bottom track (81) and checksum,
/// but no other data types. Returns the bytes written, 0 if `out` is too small.
std::size_t encode(const Pd0Ensemble& m, std::span<std::uint8_t> out);

template <class F>
void visit_fields(const Pd0FixedLeader& m, F&& field) {
  field("firmware_version", m.firmware_version);
  field("firmware_revision", m.firmware_revision);
  field("frequency_hz", m.frequency_hz);
  field("beam_angle_deg", degrees(m.beam_angle_rad));
  field("convex", m.convex);
  field("faces_up", m.faces_up);
  field("beams", m.beams);
  field("cells", m.cells);
  field("pings_per_ensemble", m.pings_per_ensemble);
  field("cell_length_m", m.cell_length_m);
  field("blank_m", m.blank_m);
  field("frame", to_string(m.frame));
  field("tilts_used", m.tilts_used);
  field("three_beam", m.three_beam);
  field("heading_alignment_deg", degrees(m.heading_alignment_rad));
  field("heading_bias_deg", degrees(m.heading_bias_rad));
  field("sensor_source", m.sensor_source);
  field("sensors_available", m.sensors_available);
}

template <class F>
void visit_fields(const Pd0VariableLeader& m, F&& field) {
  field("ensemble", m.ensemble);
  field("clock_s", m.clock ? std::optional{seconds(m.clock->time_since_epoch())} : std::nullopt);
  field("built_in_test", m.built_in_test);
  field("sound_speed_mps", m.sound_speed_mps);
  field("depth_m", m.depth_m);
  field("heading_deg", degrees(m.heading_rad));
  field("pitch_deg", degrees(m.pitch_rad));
  field("roll_deg", degrees(m.roll_rad));
  field("salinity_ppt", m.salinity_ppt);
  field("temperature_k", m.temperature_k);
  field("pressure_pa", m.pressure_pa);
}

template <class F>
void visit_fields(const Pd0BottomTrack& m, F&& field) {
  field("bottom_pings_per_ensemble", m.pings_per_ensemble);
  field("bottom_velocity_mps", m.velocity_mps);
  field("bottom_range_m", m.range_m);
  field("bottom_correlation", m.correlation);
  field("bottom_amplitude", m.amplitude);
  field("bottom_percent_good", m.percent_good);
  field("bottom_max_depth_m", m.max_depth_m);
  field("water_velocity_mps", m.water_velocity_mps);
  field("layer_near_m", m.layer_near_m);
  field("layer_far_m", m.layer_far_m);
  field("water_percent_good", m.water_percent_good);
}

template <class F>
void visit_fields(const Pd0HighResolution& m, F&& field) {
  field("fine_bottom_velocity_mps", m.bottom_velocity_mps);
  field("fine_bottom_distance_m", m.bottom_distance_m);
  field("fine_water_velocity_mps", m.water_velocity_mps);
  field("fine_water_distance_m", m.water_distance_m);
}

template <class F>
void visit_fields(const Pd0BottomRange& m, F&& field) {
  field("slant_range_m", m.slant_range_m);
  field("vertical_range_m", m.vertical_range_m);
  field("axis_difference_m", m.axis_difference_m);
  field("beam_range_m", m.beam_range_m);
}

template <class F>
void visit_fields(const Pd0Navigation& m, F&& field) {
  std::array<std::optional<double>, 4> age_s;
  for (std::size_t i = 0; i < age_s.size(); ++i) age_s[i] = seconds(m.echo_age[i]);
  field("echo_age_s", age_s);
}

/// If the ensemble does not have a data type, the visit shows the same keys with empty values.
template <class F>
void visit_fields(const Pd0Ensemble& m, F&& field) {
  visit_fields(m.variable, field);
  visit_fields(m.fixed, field);
  field("bottom_track", m.bottom_track.has_value());
  visit_fields(m.bottom_track.value_or(Pd0BottomTrack{}), field);
  visit_fields(m.high_resolution.value_or(Pd0HighResolution{}), field);
  visit_fields(m.bottom_range.value_or(Pd0BottomRange{}), field);
  visit_fields(m.navigation.value_or(Pd0Navigation{}), field);
  visit_fields(m.computer, field);
  visit_fields(m.winriver, field);
}

}  // namespace drydock::wire

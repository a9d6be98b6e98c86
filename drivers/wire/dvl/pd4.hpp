#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/dvl/dvl_frame.hpp"
#include "drivers/wire/fields.hpp"

/// Teledyne RDI PD4 and PD5: 7D, a byte that says which of the two, length, fields at fixed places,
/// sum of all bytes modulo 65536; little-endian. Source: Teledyne Pathfinder DVL Guide, P/N
/// 95B-6116-00, tables 48 and 49. Unlike PD0, the velocities on the wire are those of the vehicle:
/// no sign is reversed.
namespace drydock::wire {

struct Pd4Report : DvlGeometry {  ///< without beam angle, convex, upward and alignment
  static constexpr std::string_view type = "PD4";
  std::optional<double> frequency_hz;  ///< nominal
  DvlComponents bottom_velocity_mps;   ///< in `frame`
  /// Vertical component of each beam's range, not corrected for tilt. Empty if no bottom was found.
  std::array<std::optional<double>, 4> bottom_range_m;
  std::uint8_t bottom_status = 0;  ///< bit 2k: low correlation of beam k + 1, bit 2k + 1: low echo
  DvlComponents water_velocity_mps;           ///< relative to the water layer, in `frame`
  double layer_start_m = 0, layer_end_m = 0;  ///< vertical distance
  std::uint8_t water_status = 0;
  std::optional<std::chrono::milliseconds> first_ping;  ///< time of day of the instrument's clock
  std::uint16_t built_in_test = 0;
  std::optional<double> sound_speed_mps, temperature_k;
};

/// A PD4 report and the readings of the instrument's sensors.
struct Pd5Report : Pd4Report, DvlAttitude {
  static constexpr std::string_view type = "PD5";
  double salinity_ppt = 0, depth_m = 0;
  /// East, north, up, error since the first ping.
  std::array<double, 4> bottom_distance_m{}, water_distance_m{};
};

struct Pd4 {
  static constexpr std::string_view name = "pd4";
  static constexpr std::size_t max_frame = 47;
  static constexpr std::uint8_t structure = 0;
  using Report = Pd4Report;
  using Message = std::variant<Report>;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
};

struct Pd5 {
  static constexpr std::string_view name = "pd5";
  static constexpr std::size_t max_frame = 88;
  static constexpr std::uint8_t structure = 1;
  using Report = Pd5Report;
  using Message = std::variant<Report>;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
};

/// Returns the bytes written, 0 if `out` is too small.
std::size_t encode(const Pd4Report& m, std::span<std::uint8_t> out);
std::size_t encode(const Pd5Report& m, std::span<std::uint8_t> out);

template <class F>
void visit_fields(const Pd4Report& m, F&& field) {
  field("frame", to_string(m.frame));
  field("tilts_used", m.tilts_used);
  field("three_beam", m.three_beam);
  field("frequency_hz", m.frequency_hz);
  field("bottom_velocity_mps", m.bottom_velocity_mps);
  field("bottom_range_m", m.bottom_range_m);
  field("bottom_status", m.bottom_status);
  field("water_velocity_mps", m.water_velocity_mps);
  field("layer_start_m", m.layer_start_m);
  field("layer_end_m", m.layer_end_m);
  field("water_status", m.water_status);
  field("first_ping_s", seconds(m.first_ping));
  field("built_in_test", m.built_in_test);
  field("sound_speed_mps", m.sound_speed_mps);
  field("temperature_k", m.temperature_k);
}

template <class F>
void visit_fields(const Pd5Report& m, F&& field) {
  visit_fields(static_cast<const Pd4Report&>(m), field);
  field("salinity_ppt", m.salinity_ppt);
  field("depth_m", m.depth_m);
  field("heading_deg", degrees(m.heading_rad));
  field("pitch_deg", degrees(m.pitch_rad));
  field("roll_deg", degrees(m.roll_rad));
  field("bottom_distance_m", m.bottom_distance_m);
  field("water_distance_m", m.water_distance_m);
}

}  // namespace drydock::wire

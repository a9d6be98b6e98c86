#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/fields.hpp"
#include "drivers/wire/nmea0183/nmea0183_sentence.hpp"

/// NMEA 0183 sentences of a speed log. Talkers: VM electromagnetic, VD Doppler, VW mechanical.
namespace drydock::wire {

/// Water speed and heading. The speed is that in knots. km/h is used only if knots are empty,
/// because a common electromagnetic log always sends 0 km/h.
struct Vhw {
  static constexpr std::string_view type = "VHW";
  Talker talker{"VM"};
  std::optional<double> heading_true_rad, heading_magnetic_rad;
  std::optional<double> speed_mps;  ///< through the water, negative astern
};

/// Dual water and ground speed. Values with a status other than A are empty.
struct Vbw {
  static constexpr std::string_view type = "VBW";
  Talker talker{"VM"};
  std::optional<double> water_longitudinal_mps, water_transverse_mps;  ///< ahead, to starboard
  std::optional<double> ground_longitudinal_mps, ground_transverse_mps;
  std::optional<double> water_stern_transverse_mps, ground_stern_transverse_mps;
};

/// Distance travelled, total and since reset.
struct Vlw {
  static constexpr std::string_view type = "VLW";
  Talker talker{"VM"};
  std::optional<double> water_total_m, water_trip_m;
  std::optional<double> ground_total_m, ground_trip_m;
};

bool read(SentenceReader& fields, Vhw& m);
bool read(SentenceReader& fields, Vbw& m);
bool read(SentenceReader& fields, Vlw& m);

/// Returns the bytes written, 0 if `out` is too small.
std::size_t encode(const Vhw& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});
std::size_t encode(const Vbw& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});
std::size_t encode(const Vlw& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});

template <class F>
void visit_fields(const Vhw& m, F&& field) {
  field("talker", m.talker.text());
  field("heading_true_deg", degrees(m.heading_true_rad));
  field("heading_magnetic_deg", degrees(m.heading_magnetic_rad));
  field("speed_mps", m.speed_mps);
}

template <class F>
void visit_fields(const Vbw& m, F&& field) {
  field("talker", m.talker.text());
  field("water_longitudinal_mps", m.water_longitudinal_mps);
  field("water_transverse_mps", m.water_transverse_mps);
  field("ground_longitudinal_mps", m.ground_longitudinal_mps);
  field("ground_transverse_mps", m.ground_transverse_mps);
  field("water_stern_transverse_mps", m.water_stern_transverse_mps);
  field("ground_stern_transverse_mps", m.ground_stern_transverse_mps);
}

template <class F>
void visit_fields(const Vlw& m, F&& field) {
  field("talker", m.talker.text());
  field("water_total_m", m.water_total_m);
  field("water_trip_m", m.water_trip_m);
  field("ground_total_m", m.ground_total_m);
  field("ground_trip_m", m.ground_trip_m);
}

}  // namespace drydock::wire

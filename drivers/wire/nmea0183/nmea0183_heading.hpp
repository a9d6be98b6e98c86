#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/fields.hpp"
#include "drivers/wire/nmea0183/nmea0183_sentence.hpp"

/// NMEA 0183 sentences of a compass or a gyro: how the vehicle points.
namespace drydock::wire {

/// Heading from true north.
struct Hdt {
  static constexpr std::string_view type = "HDT";
  Talker talker{"GP"};
  std::optional<double> heading_rad;
};

/// Heading and its reliability.
struct Ths {
  static constexpr std::string_view type = "THS";
  Talker talker{"GP"};
  std::optional<double> heading_rad;  ///< empty with mode V
  Letter mode;  ///< A autonomous, E estimated, M manual, S simulated, V not valid
};

/// Heading of a magnetic sensor. Deviation and variation are positive to the east.
struct Hdg {
  static constexpr std::string_view type = "HDG";
  Talker talker{"HC"};
  std::optional<double> sensor_heading_rad;  ///< of the sensor: without its deviation
  std::optional<double> deviation_rad, variation_rad;
};

/// Heading from magnetic north.
struct Hdm {
  static constexpr std::string_view type = "HDM";
  Talker talker{"HC"};
  std::optional<double> heading_rad;
};

/// Each reads the fields after the address.
bool read(SentenceReader& fields, Hdt& m);
bool read(SentenceReader& fields, Ths& m);
bool read(SentenceReader& fields, Hdg& m);
bool read(SentenceReader& fields, Hdm& m);

/// Returns the bytes written, 0 if `out` is too small.
std::size_t encode(const Hdt& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});
std::size_t encode(const Ths& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});
std::size_t encode(const Hdg& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});
std::size_t encode(const Hdm& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});

template <class F>
void visit_fields(const Hdt& m, F&& field) {
  field("talker", m.talker.text());
  field("heading_true_deg", degrees(m.heading_rad));
}

template <class F>
void visit_fields(const Ths& m, F&& field) {
  field("talker", m.talker.text());
  field("heading_true_deg", degrees(m.heading_rad));
  field("mode", m.mode.text());
}

template <class F>
void visit_fields(const Hdg& m, F&& field) {
  field("talker", m.talker.text());
  field("sensor_heading_deg", degrees(m.sensor_heading_rad));
  field("deviation_deg", degrees(m.deviation_rad));
  field("variation_deg", degrees(m.variation_rad));
}

template <class F>
void visit_fields(const Hdm& m, F&& field) {
  field("talker", m.talker.text());
  field("heading_magnetic_deg", degrees(m.heading_rad));
}

}  // namespace drydock::wire

#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/fields.hpp"
#include "drivers/wire/nmea0183/nmea0183_sentence.hpp"

/// NMEA 0183 sentences of a satellite compass or a gyro: heading from true north.
namespace drydock::wire {

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

/// Each reads the fields after the address.
bool read(SentenceReader& fields, Hdt& m);
bool read(SentenceReader& fields, Ths& m);

/// Returns the bytes written, 0 if `out` is too small.
std::size_t encode(const Hdt& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});
std::size_t encode(const Ths& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals = {});

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

}  // namespace drydock::wire

#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/nmea0183/nmea0183_gnss.hpp"

/// Sentences of a satellite receiver that WinRiver put into an ensemble, between those of the ADCP:
/// in binary (data type 0x2022) and as text without a checksum (0x2101 GGA, 0x2102 VTG). Layout by
/// the public reader of MHKiT-Python, and by captures that have both forms of the same sentence.
namespace drydock::wire {

namespace pd0 {
constexpr std::uint16_t winriver_binary = 0x2022, winriver_gga = 0x2101, winriver_vtg = 0x2102;
}  // namespace pd0

/// `delta_s`: its time relative to the ensemble, empty for text.
struct WinRiverGga {
  std::optional<double> delta_s;
  Gga sentence;
};
struct WinRiverVtg {
  std::optional<double> delta_s;
  Vtg sentence;
};

/// In the order of the ensemble. A capture of a receiver at 10 Hz has up to 60 in one.
struct WinRiverSentences {
  static constexpr std::size_t most = 128;
  boost::container::static_vector<WinRiverGga, most> gga;
  boost::container::static_vector<WinRiverVtg, most> vtg;
};

/// Reads a data type into the list. False if it is no such sentence, cut short, or the list is
/// full.
bool read_block(Bytes block, WinRiverSentences& m);

template <class F>
void visit_fields(const WinRiverGga& m, F&& field) {
  field("delta_s", m.delta_s);
  visit_fields(m.sentence, field);
}

template <class F>
void visit_fields(const WinRiverVtg& m, F&& field) {
  field("delta_s", m.delta_s);
  visit_fields(m.sentence, field);
}

template <class F>
void visit_fields(const WinRiverSentences& m, F&& field) {
  field("gga", std::span{m.gga});
  field("vtg", std::span{m.vtg});
}

}  // namespace drydock::wire

#pragma once

#include <boost/container/static_vector.hpp>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/ubx/ubx_nav.hpp"

/// Raw measurements and raw navigation data, class 0x02 (u-blox interface descriptions, M8 to F9).
namespace drydock::wire {

struct RawMeasurement {
  UbxGnss gnss = UbxGnss::gps;
  std::uint8_t number = 0;              ///< within its constellation
  std::uint8_t signal = 0;              ///< u-blox's signal number within the constellation
  std::optional<int> frequency_number;  ///< GLONASS, -7 to 6
  std::optional<double> cno_dbhz;
  std::optional<double> pseudorange_m, pseudorange_sigma_m;          ///< empty: not valid
  std::optional<double> carrier_phase_cycles, carrier_sigma_cycles;  ///< empty: not valid
  std::optional<double> doppler_hz, doppler_sigma_hz;  ///< positive: the satellite approaches
  std::chrono::milliseconds lock_time{};               ///< of the carrier, at most 64.5 s
  bool half_cycle_resolved = false;
};

/// One epoch of raw measurements, with everything that a RINEX observation file needs.
struct RxmRawx {
  static constexpr std::string_view type = "RXM-RAWX";
  static constexpr std::uint16_t class_and_id = 0x0215;
  RxmRawx() {}                      // read in place, see message_list.hpp
  double receiver_time_s = 0;       ///< time of the GPS week, by the receiver's clock
  int gps_week = 0;                 ///< by the receiver's clock
  std::optional<int> leap_seconds;  ///< GPS - UTC; empty until the receiver knows it
  bool clock_reset = false;         ///< since the previous epoch
  boost::container::static_vector<RawMeasurement, 255> measurements;
};

/// A part of a broadcast navigation message, in the words of its signal. For GPS L1 C/A that is one
/// subframe: ten words of 30 bits, parity included.
struct RxmSfrbx {
  static constexpr std::string_view type = "RXM-SFRBX";
  static constexpr std::uint16_t class_and_id = 0x0213;
  RxmSfrbx() {}  // read in place, see message_list.hpp
  UbxGnss gnss = UbxGnss::gps;
  std::uint8_t number = 0;
  std::uint8_t signal = 0;
  std::optional<int> frequency_number;
  std::uint8_t channel = 0;
  boost::container::static_vector<std::uint32_t, 255> words;
};

bool read(Bytes payload, RxmRawx& m);
bool read(Bytes payload, RxmSfrbx& m);

template <class F>
void visit_fields(const RawMeasurement& m, F&& field) {
  field("gnss", to_string(m.gnss));
  field("number", m.number);
  field("signal", m.signal);
  field("frequency_number", m.frequency_number);
  field("cno_dbhz", m.cno_dbhz);
  field("pseudorange_m", m.pseudorange_m);
  field("pseudorange_sigma_m", m.pseudorange_sigma_m);
  field("carrier_phase_cycles", m.carrier_phase_cycles);
  field("carrier_sigma_cycles", m.carrier_sigma_cycles);
  field("doppler_hz", m.doppler_hz);
  field("doppler_sigma_hz", m.doppler_sigma_hz);
  field("lock_time_s", seconds(m.lock_time));
  field("half_cycle_resolved", m.half_cycle_resolved);
}

template <class F>
void visit_fields(const RxmRawx& m, F&& field) {
  field("receiver_time_s", m.receiver_time_s);
  field("gps_week", m.gps_week);
  field("leap_seconds", m.leap_seconds);
  field("clock_reset", m.clock_reset);
  field("measurements", std::span{m.measurements});
}

template <class F>
void visit_fields(const RxmSfrbx& m, F&& field) {
  field("gnss", to_string(m.gnss));
  field("number", m.number);
  field("signal", m.signal);
  field("frequency_number", m.frequency_number);
  field("channel", m.channel);
  field("words", std::span{m.words});
}

}  // namespace drydock::wire

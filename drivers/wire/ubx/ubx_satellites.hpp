#pragma once

#include <boost/container/static_vector.hpp>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/ubx/ubx_nav.hpp"

/// Messages about satellites other than NAV-SAT. Receivers before NAV-SAT list channels; receivers
/// with several frequencies list signals (u-blox interface descriptions, M8 to F9).
namespace drydock::wire {

/// Satellites by channel. One number on the wire gives both constellation and number. Numbers of
/// unknown constellations are omitted.
struct NavSvinfo {
  static constexpr std::string_view type = "NAV-SVINFO";
  static constexpr std::uint16_t class_and_id = 0x0130;
  NavSvinfo() {}                                  // read in place, see message_list.hpp
  static constexpr std::uint8_t m8_hardware = 4;  ///< of the flags that encode() writes
  std::chrono::milliseconds itow{};
  boost::container::static_vector<UbxSatellite, 255> satellites;
};

struct UbxSignal {
  UbxGnss gnss = UbxGnss::gps;
  std::uint8_t number = 0;              ///< within its constellation
  std::uint8_t signal = 0;              ///< u-blox's signal number within the constellation
  std::optional<int> frequency_number;  ///< GLONASS, -7 to 6
  std::optional<double> cno_dbhz;       ///< empty: not tracked
  double residual_m = 0;                ///< of the pseudorange
  std::uint8_t quality = 0;             ///< as in NAV-SAT
  std::uint8_t correction_source = 0;   ///< 0 none, 1 SBAS, 2 BeiDou, 3 RTCM 2, 4 RTCM 3 OSR, ...
  std::uint8_t ionosphere_model = 0;    ///< 0 none, 1 GPS, 2 SBAS, 3 BeiDou, 8 two frequencies
  std::optional<bool> healthy;
  bool pseudorange_used = false, carrier_used = false, doppler_used = false;
};

/// Signals; one satellite may have several. The message has no directions.
struct NavSig {
  static constexpr std::string_view type = "NAV-SIG";
  static constexpr std::uint16_t class_and_id = 0x0143;
  NavSig() {}  // read in place, see message_list.hpp
  std::chrono::milliseconds itow{};
  boost::container::static_vector<UbxSignal, 255> signals;
};

bool read(Bytes payload, NavSvinfo& m);
bool read(Bytes payload, NavSig& m);

/// NAV-SVINFO of an M8, with GPS satellites only: others have no place in its numbers here. Returns
/// the bytes of the whole frame, 0 if `out` is too small.
std::size_t encode(const NavSvinfo& m, std::span<std::uint8_t> out);

template <class F>
void visit_fields(const NavSvinfo& m, F&& field) {
  field("itow_s", seconds(m.itow));
  field("satellites", std::span{m.satellites});
}

template <class F>
void visit_fields(const UbxSignal& m, F&& field) {
  field("gnss", to_string(m.gnss));
  field("number", m.number);
  field("signal", m.signal);
  field("frequency_number", m.frequency_number);
  field("cno_dbhz", m.cno_dbhz);
  field("residual_m", m.residual_m);
  field("quality", m.quality);
  field("correction_source", m.correction_source);
  field("ionosphere_model", m.ionosphere_model);
  field("healthy", m.healthy);
  field("pseudorange_used", m.pseudorange_used);
  field("carrier_used", m.carrier_used);
  field("doppler_used", m.doppler_used);
}

template <class F>
void visit_fields(const NavSig& m, F&& field) {
  field("itow_s", seconds(m.itow));
  field("signals", std::span{m.signals});
}

}  // namespace drydock::wire

#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "hil/emulate/emulated_device.hpp"

namespace drydock::emulate {

/// The sentences of a receiver in the order on the line.
inline constexpr std::array<std::string_view, 7> nmea_receiver_sentences{"RMC", "GGA", "VTG", "GSA",
                                                                         "GSV", "GLL", "ZDA"};

/// What the usual commands of NMEA receivers set: $PUBX,40 and 41 (u-blox 8 / M8 Receiver
/// Description, UBX-13003221), $PMTK220, 251 and 314 (GlobalTop, PMTK command packet, rev. A11).
/// Other PMTK commands are answered as not supported.
class NmeaCommands {
 public:
  void receive(wire::Bytes bytes, Wire& out);

  /// Epochs between two sentences of a kind; 0: it is off.
  int each(std::size_t sentence) const { return each_[sentence]; }
  /// That a host has asked for.
  std::optional<double> period_s() const { return period_s_; }

 private:
  void on_sentence(std::string_view text, Wire& out);
  void on_pubx_rate(std::string_view fields, Wire& out);
  void on_pubx_port(std::string_view fields, Wire& out);
  bool on_pmtk(int command, std::string_view fields, Wire& out);
  bool set_baud(std::optional<int> rate, Wire& out);
  bool set_outputs(std::string_view fields);
  void tell(std::string_view text, Wire& out) const { out.tell(text); }

  static constexpr std::array<int, 7> delivered{1, 1, 1, 1, 1, 0, 1};
  std::array<int, 7> each_ = delivered;
  std::optional<double> period_s_;
  wire::Framer<wire::Nmea0183::max_frame> framer_;
};

}  // namespace drydock::emulate

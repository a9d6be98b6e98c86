#pragma once

#include <vector>

#include "drivers/recordings/slice/displacement.hpp"
#include "drivers/wire/ubx/ubx_nmea.hpp"

namespace drydock::slice {

/// What a satellite receiver, or whoever speaks NMEA 0183 or UBX, sent, at another place. Only
/// messages are kept that hold no position, or whose position was moved; satellites, raw
/// measurements, unknown messages and bytes outside of messages are dropped and counted. Heights
/// become those above mean sea level, geoid and magnetic declination are left out: they too are a
/// map of the Earth.
class ReceiverLine {
 public:
  ReceiverLine(Displacement& place, Dropped& dropped) : place_(place), dropped_(dropped) {}

  /// What becomes of these bytes: the messages that end in them.
  wire::Bytes move(wire::Bytes bytes);
  std::uint64_t moved() const { return moved_; }

 private:
  void on_frame(wire::Bytes frame);
  void on_sentence(wire::Bytes frame);
  void on_ubx(wire::Bytes frame);
  void drop(std::string what) { ++dropped_[std::move(what)]; }

  Displacement& place_;
  Dropped& dropped_;
  wire::Framer<wire::UbxNmea::max_frame> framer_;
  std::vector<std::uint8_t> out_;
  std::uint64_t moved_ = 0, skipped_ = 0;
};

}  // namespace drydock::slice

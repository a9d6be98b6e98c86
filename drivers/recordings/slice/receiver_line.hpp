#pragma once

#include <vector>

#include "drivers/recordings/slice/displacement.hpp"
#include "drivers/wire/ubx/ubx_nmea.hpp"

namespace drydock::slice {

/// Moves the data of a satellite receiver, or of any device that speaks NMEA 0183 or UBX, to
/// another place. It keeps only messages without a position and messages whose position it moved.
/// It drops and counts satellites, raw measurements, unknown messages and bytes outside of
/// messages. It replaces heights by those above mean sea level, and omits geoid and magnetic
/// declination: these values also show the place.
class ReceiverLine {
 public:
  ReceiverLine(Displacement& place, Dropped& dropped) : place_(place), dropped_(dropped) {}

  /// Returns the messages that end in these bytes, after the move.
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

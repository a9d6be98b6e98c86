#pragma once

#include <vector>

#include "drivers/device/timed_framer.hpp"
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

  /// Messages that ended in one read, after the move.
  struct Moved {
    measurement::Stamp at;  ///< of that read
    std::vector<std::uint8_t> bytes;
  };
  /// Returns the messages that come out with this read, by the reads in which they ended: messages
  /// behind a damaged length come out late. Valid until the next call.
  const std::vector<Moved>& move(wire::Bytes bytes, measurement::Stamp at);
  /// No more reads will come. Returns the messages that still waited.
  const std::vector<Moved>& finish();
  std::uint64_t moved() const { return moved_; }

 private:
  auto taker() {
    return [this](wire::Bytes frame, const device::Arrival& arrival) {
      on_frame(frame, arrival.read_at);
    };
  }
  void on_frame(wire::Bytes frame, measurement::Stamp at);
  void on_sentence(wire::Bytes frame, measurement::Stamp at);
  void on_ubx(wire::Bytes frame, measurement::Stamp at);
  void keep(wire::Bytes frame, measurement::Stamp at);
  void count_skipped();
  void drop(std::string what) { ++dropped_[std::move(what)]; }

  Displacement& place_;
  Dropped& dropped_;
  device::TimedFramer<wire::UbxNmea::max_frame> framer_;
  std::vector<Moved> out_;
  std::uint64_t moved_ = 0, skipped_ = 0;
};

}  // namespace drydock::slice

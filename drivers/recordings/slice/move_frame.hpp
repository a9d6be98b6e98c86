#pragma once

#include <set>

#include "drivers/recordings/slice/displacement.hpp"
#include "drivers/wire/can/can_frame.hpp"

namespace drydock::slice {

/// Frames of a CAN bus at another place. Of NMEA 2000 the rapid position update (129025) is moved;
/// what else tells a place (fixes, satellites, routes, other vessels) is dropped and counted, also
/// inside the transport protocol.
class BusPlace {
 public:
  BusPlace(Displacement& place, Dropped& dropped) : place_(place), dropped_(dropped) {}

  /// False: dropped.
  bool move(wire::CanFrame& frame);
  std::uint64_t moved() const { return moved_; }

 private:
  bool drop(std::uint32_t pgn);

  Displacement& place_;
  Dropped& dropped_;
  std::set<std::uint8_t> hidden_transport_;  ///< sources in the middle of such a message
  std::uint64_t moved_ = 0;
};

}  // namespace drydock::slice

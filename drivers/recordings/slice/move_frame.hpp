#pragma once

#include <set>

#include "drivers/recordings/slice/displacement.hpp"
#include "drivers/wire/can/can_frame.hpp"

namespace drydock::slice {

/// Moves frames of a CAN bus to another place. In NMEA 2000 it moves the rapid position update
/// (129025). It drops and counts all other frames that show a place (fixes, satellites, routes,
/// other vessels), also inside the transport protocol.
class BusPlace {
 public:
  BusPlace(Displacement& place, Dropped& dropped) : place_(place), dropped_(dropped) {}

  /// False if the frame is dropped.
  bool move(wire::CanFrame& frame);
  std::uint64_t moved() const { return moved_; }

 private:
  bool drop(std::uint32_t pgn);

  Displacement& place_;
  Dropped& dropped_;
  std::set<std::uint8_t> hidden_transport_;  ///< sources that are sending such a message in parts
  std::uint64_t moved_ = 0;
};

}  // namespace drydock::slice

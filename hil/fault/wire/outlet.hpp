#pragma once

#include "drivers/measurement/stamp.hpp"
#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::fault {

/// The drivers' end of a real or recorded wire. `at` is the time at which the last bit came, or
/// would have come.
class Outlet {
 public:
  virtual ~Outlet() = default;
  virtual void pass(wire::Bytes bytes, measurement::Stamp at) = 0;
  virtual void pass(const wire::CanFrame& frame, measurement::Stamp at) = 0;
  /// The port disappears or comes back.
  virtual void set_port(bool there, measurement::Stamp at) = 0;
};

}  // namespace drydock::fault

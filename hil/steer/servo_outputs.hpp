#pragma once

#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <optional>

#include "drivers/wire/codec.hpp"

namespace drydock::steer {

/// A packet of ArduPilot's JSON physics interface: what the autopilot wants of its actuators, and
/// how long the step is. Source: ArduPilot, "JSON SITL backend" (libraries/SITL/examples/JSON).
struct ServoOutputs {
  std::uint16_t rate_hz = 0;                                    ///< the step lasts 1 / rate_hz
  std::uint32_t count = 0;                                      ///< one more with each step
  boost::container::static_vector<std::uint16_t, 32> pulse_us;  ///< 0: the output is not in use
};

/// Little-endian: magic 18458 with 16 outputs, or 29569 with 32. Empty: the packet is none.
std::optional<ServoOutputs> read_servo_outputs(wire::Bytes packet);

/// -1 at 1100 us, 0 at 1500 us, 1 at 1900 us, not beyond; 0 for an output that is not in use.
double normalised(std::uint16_t pulse_us);

}  // namespace drydock::steer

#pragma once

#include <boost/system/result.hpp>
#include <cstdint>
#include <memory>
#include <string>

#include "hil/emulate/condition.hpp"
#include "hil/emulate/emulated_device.hpp"
#include "hil/motion/truth.hpp"
#include "rig_config/rig.hpp"

namespace drydock::emulate {

/// One line: what is wrong, what is allowed.
struct EmulateError {
  std::string message;
};

/// Called by result::value() when there is none; throws std::invalid_argument.
[[noreturn]] void throw_exception_from_error(const EmulateError& error,
                                             const boost::source_location& where);

/// When a device gets power and what faults make of it.
struct PowerUp {
  measurement::Stamp boot{};
  std::shared_ptr<const Condition> condition;
};

/// The emulated device for a kind and protocol. It boots at trajectory.start() and samples every
/// 1/rate_hz from then on (GNSS: at whole multiples of that in UTC). The trajectory must outlive
/// it.
boost::system::result<std::unique_ptr<EmulatedDevice>, EmulateError> make_emulated_device(
    const rig_config::DeviceConfig& config, const motion::Trajectory& trajectory,
    std::uint64_t seed);

/// The same, booting when it gets power.
boost::system::result<std::unique_ptr<EmulatedDevice>, EmulateError> make_emulated_device(
    const rig_config::DeviceConfig& config, const motion::Trajectory& trajectory,
    std::uint64_t seed, const PowerUp& power);

}  // namespace drydock::emulate

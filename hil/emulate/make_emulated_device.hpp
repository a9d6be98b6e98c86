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

/// Makes the devices of a rig for a bench: sound ones, or those of hil/fault.
class DeviceMaker {
 public:
  using Made = boost::system::result<std::unique_ptr<EmulatedDevice>, EmulateError>;

  virtual ~DeviceMaker() = default;
  virtual Made device(const rig_config::DeviceConfig& config) = 0;
  /// What else its bus needs beside a device; nullptr: nothing.
  virtual std::unique_ptr<EmulatedDevice> rogue(const rig_config::DeviceConfig& config,
                                                unsigned bit_rate) = 0;
};

/// Devices without a fault. The trajectory must outlive what it makes.
class SoundDevices final : public DeviceMaker {
 public:
  SoundDevices(const motion::Trajectory& trajectory, std::uint64_t seed)
      : trajectory_(trajectory), seed_(seed) {}
  Made device(const rig_config::DeviceConfig& config) override {
    return make_emulated_device(config, trajectory_, seed_);
  }
  std::unique_ptr<EmulatedDevice> rogue(const rig_config::DeviceConfig&, unsigned) override {
    return nullptr;
  }

 private:
  const motion::Trajectory& trajectory_;
  std::uint64_t seed_;
};

}  // namespace drydock::emulate

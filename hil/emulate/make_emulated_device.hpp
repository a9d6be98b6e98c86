#pragma once

#include <boost/system/result.hpp>
#include <cstdint>
#include <memory>
#include <string>

#include "hil/emulate/condition.hpp"
#include "hil/emulate/emulated_device.hpp"
#include "hil/emulate/memory.hpp"
#include "hil/motion/truth.hpp"
#include "rig_config/rig.hpp"

namespace drydock::emulate {

/// One line: what is wrong and what is allowed.
struct EmulateError {
  std::string message;
  std::string key = {};  ///< of the device in the rig file, such as `emulate/sky/at`; may be empty
};

/// Called by result::value() if there is no device; throws std::invalid_argument.
[[noreturn]] void throw_exception_from_error(const EmulateError& error,
                                             const boost::source_location& where);

/// When a device gets power, and the effects of faults on it.
struct PowerUp {
  measurement::Stamp boot{};
  std::shared_ptr<const Condition> condition;                   ///< null: no fault has effect
  std::shared_ptr<Memory> memory = std::make_shared<Memory>();  ///< outlives a loss of power
};

/// The emulated device for a kind and protocol. It boots at trajectory.start() and then samples
/// every 1/rate_hz (GNSS: at whole multiples of that in UTC). The trajectory must outlive it.
boost::system::result<std::unique_ptr<EmulatedDevice>, EmulateError> make_emulated_device(
    const rig_config::DeviceConfig& config, const motion::Trajectory& trajectory,
    std::uint64_t seed);

/// The same, but the device boots when it gets power.
boost::system::result<std::unique_ptr<EmulatedDevice>, EmulateError> make_emulated_device(
    const rig_config::DeviceConfig& config, const motion::Trajectory& trajectory,
    std::uint64_t seed, const PowerUp& power);

/// Makes the devices of a rig for a bench: sound devices, or the faulty ones of hil/fault.
class DeviceMaker {
 public:
  using Made = boost::system::result<std::unique_ptr<EmulatedDevice>, EmulateError>;

  virtual ~DeviceMaker() = default;
  virtual Made device(const rig_config::DeviceConfig& config) = 0;
  /// An extra node that the bus needs because of a device; null: none.
  virtual std::unique_ptr<EmulatedDevice> rogue(const rig_config::DeviceConfig& config,
                                                unsigned bit_rate) = 0;
};

/// Makes devices without faults. The trajectory must outlive them.
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

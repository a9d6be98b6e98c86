#pragma once

#include "hil/fault/faulty_device.hpp"
#include "hil/fault/rogue_node.hpp"
#include "hil/fault/schedule/schedules.hpp"

namespace drydock::fault {

/// Problems: the rig does not have the device, the device cannot have the fault, or this program
/// does not emulate the device.
rig_config::Problems check_faults(const rig_config::Rig& rig);

/// Puts faults on the emulated devices of a rig: those of its files, and those set by hand during
/// the run.
class Injector final : public emulate::DeviceMaker {
 public:
  /// Times of the rig's faults count from `start`. Rig and trajectory must outlive the injector.
  Injector(const rig_config::Rig& rig, const motion::Trajectory& trajectory, Stamp start);

  /// The emulated device, wrapped in its faults.
  Made device(const DeviceConfig& config) override;

  /// The extra node that the faults of a device on a bus need.
  std::unique_ptr<emulate::EmulatedDevice> rogue(const DeviceConfig& config,
                                                 unsigned bit_rate) override;

  /// Sets a fault by hand; its times count from now. It replaces an earlier fault of the same kind
  /// and quantity that was set by hand. Fails with a line if the device cannot have it.
  boost::system::result<void, rig_config::Problems> set(const FaultConfig& fault, Stamp now);
  /// Returns how many faults were removed. An empty device or kind means all.
  std::size_t clear(const std::string& device, std::optional<FaultKind> kind) {
    return schedules_.clear(device, kind);
  }
  std::vector<FaultNow> in_force(Stamp at) const { return schedules_.in_force(at); }
  /// Those of one device of the rig. The pointers are valid until a fault is set or cleared.
  std::vector<InForce> faults_of(const std::string& device, Stamp at) const {
    return schedules_.of(device)->in_force(at);
  }
  /// The next change of any device.
  std::optional<Stamp> next_change(Stamp after) const { return schedules_.next_change(after); }

 private:
  const rig_config::Rig& rig_;
  const motion::Trajectory& trajectory_;
  Stamp start_;
  Schedules schedules_;
};

}  // namespace drydock::fault

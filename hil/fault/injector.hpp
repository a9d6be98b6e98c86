#pragma once

#include "hil/fault/faulty_device.hpp"
#include "hil/fault/rogue_node.hpp"
#include "hil/fault/schedule/schedules.hpp"

namespace drydock::fault {

/// Faults of devices that the rig has not, that cannot have them, or whose other end is not played
/// by this program.
rig_config::Problems check_faults(const rig_config::Rig& rig);

/// The faults of a rig: puts them on its emulated devices, by the files or by hand while it runs.
class Injector final : public emulate::DeviceMaker {
 public:
  /// Times of the rig's faults count from `start`. Rig and trajectory outlive it.
  Injector(const rig_config::Rig& rig, const motion::Trajectory& trajectory, Stamp start);

  /// The device with its faults around it.
  Made device(const DeviceConfig& config) override;

  /// What the faults of a device on a bus need there beside it.
  std::unique_ptr<emulate::EmulatedDevice> rogue(const DeviceConfig& config,
                                                 unsigned bit_rate) override;

  /// By hand: its times count from now; it takes the place of one of its kind that was set by hand
  /// before. Fails with a line where the device cannot have it.
  boost::system::result<void, rig_config::Problems> set(const FaultConfig& fault, Stamp now);
  /// How many were taken away; of no device or kind: of all.
  std::size_t clear(const std::string& device, std::optional<FaultKind> kind) {
    return schedules_.clear(device, kind);
  }
  std::vector<FaultNow> in_force(Stamp at) const { return schedules_.in_force(at); }
  /// Of any device.
  std::optional<Stamp> next_change(Stamp after) const { return schedules_.next_change(after); }

 private:
  const rig_config::Rig& rig_;
  const motion::Trajectory& trajectory_;
  Stamp start_;
  Schedules schedules_;
};

}  // namespace drydock::fault

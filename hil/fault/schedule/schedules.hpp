#pragma once

#include <map>
#include <memory>
#include <string>

#include "hil/fault/schedule/schedule.hpp"
#include "rig_config/load.hpp"

namespace drydock::fault {

/// A device and the fault that it has now.
struct FaultNow {
  std::string device, name, words;  ///< name: word of the vocabulary
  Stamp since{};
  std::optional<Stamp> until;

  friend bool operator==(const FaultNow&, const FaultNow&) = default;
};

/// The faults of all devices of one target: those of the files, and those set by hand during the
/// run.
class Schedules {
 public:
  /// Times of the rig's faults count from `start`. The rig must outlive this object, and
  /// check_faults_of() must accept its faults.
  Schedules(const rig_config::Rig& rig, Stamp start, rig_config::FaultTarget target);

  const std::shared_ptr<Schedule>& of(const std::string& device) const {
    return by_device_.at(device);
  }

  /// Sets a fault by hand from now on. Fails with a line if the device cannot have it.
  boost::system::result<void, rig_config::Problems> set(const FaultConfig& fault, Stamp now);
  /// Returns how many faults were removed. An empty device or kind means all.
  std::size_t clear(const std::string& device, std::optional<FaultKind> kind);

  std::vector<FaultNow> in_force(Stamp at) const;
  std::optional<Stamp> next_change(Stamp after) const;  ///< any device

 private:
  const rig_config::Rig& rig_;
  rig_config::FaultTarget target_;
  std::map<std::string, std::shared_ptr<Schedule>> by_device_;
};

}  // namespace drydock::fault

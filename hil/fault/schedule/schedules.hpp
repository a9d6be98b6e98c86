#pragma once

#include <map>
#include <memory>
#include <string>

#include "hil/fault/schedule/schedule.hpp"
#include "rig_config/load.hpp"

namespace drydock::fault {

/// Who has which fault, for those who look on.
struct FaultNow {
  std::string device, name, words;  ///< name: of the vocabulary
  Stamp since{};
  std::optional<Stamp> until;

  friend bool operator==(const FaultNow&, const FaultNow&) = default;
};

/// The faults of all devices behind one kind of wire: those of the files, and by hand while it
/// runs.
class Schedules {
 public:
  /// Times of the rig's faults count from `start`. The rig outlives it, and its faults are such as
  /// check_faults_of() has nothing against.
  Schedules(const rig_config::Rig& rig, Stamp start, rig_config::FaultTarget target);

  const std::shared_ptr<Schedule>& of(const std::string& device) const {
    return by_device_.at(device);
  }

  /// By hand: one from now on. Fails with a line where the device cannot have it.
  boost::system::result<void, rig_config::Problems> set(const FaultConfig& fault, Stamp now);
  /// How many were taken away; of no device or kind: of all.
  std::size_t clear(const std::string& device, std::optional<FaultKind> kind);

  std::vector<FaultNow> in_force(Stamp at) const;
  std::optional<Stamp> next_change(Stamp after) const;  ///< of any device

 private:
  const rig_config::Rig& rig_;
  rig_config::FaultTarget target_;
  std::map<std::string, std::shared_ptr<Schedule>> by_device_;
};

}  // namespace drydock::fault

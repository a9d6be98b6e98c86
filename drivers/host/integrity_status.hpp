#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/host/follower.hpp"

namespace drydock::host {

/// Statuses of `rt/diagnostics` for what the estimators promise: "leveling/integrity" with the
/// bounds in degrees and metres (docs/estimators/integrity.md), each time an estimate becomes valid
/// or ceases to be, and once a second.
class IntegrityStatuses {
 public:
  /// `estimators`: their names, by `Estimate::estimator`.
  explicit IntegrityStatuses(std::vector<std::string> estimators);

  /// Empty: there is nothing new.
  std::optional<bus::DeviceStatus> take(const Estimate& estimate);

 private:
  struct Told {
    std::string name;
    measurement::Stamp at{};
    bool valid = false;
  };
  std::vector<Told> told_;
};

}  // namespace drydock::host

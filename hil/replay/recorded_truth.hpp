#pragma once

#include <map>
#include <optional>
#include <string>

#include "drivers/host/follower.hpp"
#include "drivers/recordings/record/layouts.hpp"
#include "drivers/recordings/record/recording.hpp"

namespace drydock::replay {

/// Reads the truth in a recording (`/estimate/truth...`, written for an emulated vehicle) and tells
/// it to a follower, as in the run.
class RecordedTruth {
 public:
  /// The follower must outlive it.
  explicit RecordedTruth(host::Follower& to) : to_(to) {}

  void hear(const record::Understood& message);
  void tell();  ///< what has been read and not yet told; call it at the end

 private:
  std::map<std::string, double> values(const record::Understood& message);
  void take(const std::string& topic, const std::map<std::string, double>& values,
            measurement::Stamp at);

  host::Follower& to_;
  record::Layouts layouts_;
  std::optional<host::Estimate> truth_;  ///< waits for the rest of its time
  bus::Navigation navigation_;           ///< the odometry comes before the fix
};

}  // namespace drydock::replay

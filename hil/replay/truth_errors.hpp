#pragma once

#include <map>
#include <optional>
#include <vector>

#include "drivers/host/watcher.hpp"
#include "drivers/recordings/record/message_layout.hpp"
#include "drivers/recordings/record/recording.hpp"
#include "estimators/pipeline/inertial/navigation_estimate.hpp"
#include "rig_config/rig.hpp"

namespace drydock::replay {

/// Compares estimates of a replay with the truth in the recording (`/estimate/truth...`, written
/// for an emulated vehicle). An estimate counts only if a truth has exactly the same time.
class TruthErrors {
 public:
  struct Rms {
    std::uint64_t attitudes = 0, positions = 0;  ///< number of comparisons
    double roll_deg = 0, pitch_deg = 0, horizontal_m = 0;
  };

  /// The truth is also passed to `watchers`, as in the run.
  TruthErrors(const rig_config::Rig& rig, host::Watchers& watchers)
      : watchers_(watchers), truth_index_(rig.estimators.size()), sums_(rig.estimators.size()) {}

  void note(const pipeline::AttitudeEstimate& estimate);
  void note(const pipeline::NavigationEstimate& estimate);
  void hear(const record::Understood& message);

  Rms of(std::size_t estimator) const;

 private:
  using Stamp = measurement::Stamp;
  struct Waiting {
    std::size_t estimator = 0;
    std::optional<frame::Position> position;
    double roll_rad = 0, pitch_rad = 0;
  };
  struct Sums {
    std::uint64_t attitudes = 0, positions = 0;
    double roll2 = 0, pitch2 = 0, horizontal2 = 0;
  };

  std::map<std::string, double> values(const record::Understood& message);
  void compare_attitude(const bus::Attitude& truth);
  void compare_position(Stamp at, const frame::Position& truth);
  void keep(Stamp at, Waiting waiting);

  host::Watchers& watchers_;
  std::size_t truth_index_;
  std::vector<Sums> sums_;
  std::map<std::string, record::MessageNode> layouts_;  ///< by type
  std::multimap<Stamp, Waiting> waiting_;               ///< estimates that wait for the truth of
                                                        ///< their time
  bus::Navigation navigation_;                          ///< the odometry comes before the fix
};

}  // namespace drydock::replay

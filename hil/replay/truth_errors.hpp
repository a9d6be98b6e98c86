#pragma once

#include <map>
#include <optional>
#include <vector>

#include "drivers/host/follower.hpp"
#include "estimators/frame/geodetic.hpp"
#include "rig_config/rig.hpp"

namespace drydock::replay {

/// Compares the estimates of a replay with the truth in the recording. An estimate counts only if a
/// truth has exactly the same time.
class TruthErrors final : public host::Follower {
 public:
  struct Rms {
    std::uint64_t attitudes = 0, positions = 0;  ///< number of comparisons
    double roll_deg = 0, pitch_deg = 0, horizontal_m = 0;
  };

  explicit TruthErrors(const rig_config::Rig& rig) : sums_(rig.estimators.size()) {}

  void on_estimate(const host::Estimate& estimate) override;
  void on_truth(const host::Estimate& truth) override;

  Rms of(std::size_t estimator) const;

 private:
  struct Waiting {
    std::size_t estimator = 0;
    std::optional<frame::Position> position;
    double roll_rad = 0, pitch_rad = 0;
  };
  struct Sums {
    std::uint64_t attitudes = 0, positions = 0;
    double roll2 = 0, pitch2 = 0, horizontal2 = 0;
  };

  void compare_attitude(const bus::Attitude& truth);
  void compare_position(Stamp at, const frame::Position& truth);

  std::vector<Sums> sums_;
  std::multimap<Stamp, Waiting> waiting_;  ///< estimates that wait for the truth of their time
};

}  // namespace drydock::replay

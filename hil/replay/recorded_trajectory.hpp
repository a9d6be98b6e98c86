#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drivers/host/follower.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::replay {

/// The recorded truth as a motion: attitude, position and velocity, interpolated between the
/// recorded times. It has no forces, no rates, no water.
class RecordedTrajectory final : public motion::Trajectory {
 public:
  /// Reads the whole file. Null if it has no truth with positions.
  static std::unique_ptr<RecordedTrajectory> read(const std::string& recording);

  /// `truth` in the order of time, with navigation each; two at least.
  explicit RecordedTrajectory(const std::vector<host::Estimate>& truth);

  motion::Truth at(measurement::Stamp time) const override;  ///< outside: the first or last
  measurement::Stamp start() const override { return truth_.front().at; }
  measurement::Stamp end() const override { return truth_.back().at; }

 private:
  std::vector<motion::Truth> truth_;
};

}  // namespace drydock::replay

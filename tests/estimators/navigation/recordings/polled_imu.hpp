#pragma once

#include <Eigen/Core>
#include <span>

#include "tests/estimators/navigation/recordings/table.hpp"

/// An IMU that runs by its own clock and a logger that polls it at nearly the same rate: some
/// samples are read twice, others never. Equations: docs/estimators/real-data.md.
namespace drydock::navigation::test {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// What the logger read at `t` (s): the newest sample, which may be the one it read before.
struct Poll {
  double t;
  Vector6 value;
};

/// A sample of the IMU's own, taken at `t`. `missed`: one standard deviation of what filling in a
/// sample that was never read misses; zero where it was read.
struct OwnSample {
  double t;
  Vector6 value, missed = Vector6::Zero();
};

struct OwnSamples {
  std::vector<OwnSample> samples;  ///< every one between the first and the last that was read
  double period_s;
  std::size_t repeated, lost;
};

/// The polls as they are where fewer than 20 repeat what was read before. Refused: repeats that no
/// steady clock of the IMU explains, and too few whole stretches to fill lost samples from.
Read<OwnSamples> own_samples(std::span<const Poll> polls);

}  // namespace drydock::navigation::test

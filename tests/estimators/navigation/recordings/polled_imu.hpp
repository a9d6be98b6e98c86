#pragma once

#include <Eigen/Core>
#include <span>

#include "tests/estimators/navigation/recordings/table.hpp"

/// An IMU runs on its own clock, and a logger polls it at nearly the same rate. So the logger reads
/// some samples twice and others never. Equations: docs/estimators/real-data.md.
namespace drydock::navigation::test {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The value that the logger read at `t` (s): the newest sample, perhaps the same as in the poll
/// before.
struct Poll {
  double t;
  Vector6 value;
};

/// One of the IMU's own samples, taken at `t`. `missed`: one standard deviation of the error of a
/// filled-in sample; zero if the sample was read.
struct OwnSample {
  double t;
  Vector6 value, missed = Vector6::Zero();
};

struct OwnSamples {
  std::vector<OwnSample> samples;  ///< all samples from the first to the last read one
  double period_s;
  std::size_t repeated, lost;
};

/// Restores the IMU's own samples. With fewer than 20 repeats the polls are returned unchanged.
/// Refused: repeats that no steady clock explains, and too few complete stretches to learn from.
Read<OwnSamples> own_samples(std::span<const Poll> polls);

}  // namespace drydock::navigation::test

#include "hil/sensor/allan.hpp"

namespace drydock::sensor {

/// Every second cluster of an octave completes one of the next octave, whose mean is the mean of
/// both.
void AllanVariance::add(const Eigen::Vector3d& sample) {
  Eigen::Vector3d mean = sample;
  for (std::size_t octave = 0;; ++octave) {
    if (octave == octaves_.size()) octaves_.emplace_back();
    Octave& here = octaves_[octave];
    if (here.clusters > 0) here.squares += (mean - here.last).cwiseAbs2();
    const Eigen::Vector3d pair = (mean + here.last) / 2;
    here.last = mean;
    if (++here.clusters % 2 != 0) return;
    mean = pair;
  }
}

std::vector<AllanVariance::Point> AllanVariance::points(std::uint64_t fewest) const {
  std::vector<Point> points;
  std::uint64_t samples = 1;
  for (const Octave& octave : octaves_) {
    if (octave.clusters >= fewest && octave.clusters > 1)
      points.push_back({samples, octave.clusters,
                        octave.squares / (2 * static_cast<double>(octave.clusters - 1))});
    samples *= 2;
  }
  return points;
}

}  // namespace drydock::sensor

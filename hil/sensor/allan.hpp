#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace drydock::sensor {

/// Allan variance of three series at 1, 2, 4, 8, ... samples (IEEE Std 952, annex C: adjacent
/// clusters that do not overlap). It is computed while samples come; the memory grows with the
/// logarithm of their number.
class AllanVariance {
 public:
  void add(const Eigen::Vector3d& sample);

  struct Point {
    std::uint64_t samples = 1;   ///< per cluster
    std::uint64_t clusters = 0;  ///< complete ones
    Eigen::Vector3d variance;    ///< half the mean square difference of adjacent clusters
  };
  /// Cluster lengths with at least `fewest` clusters.
  std::vector<Point> points(std::uint64_t fewest = 9) const;

 private:
  struct Octave {
    Eigen::Vector3d last = Eigen::Vector3d::Zero();  ///< the previous cluster
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    std::uint64_t clusters = 0;
  };
  std::vector<Octave> octaves_;
};

}  // namespace drydock::sensor

#pragma once

#include <Eigen/Geometry>
#include <deque>
#include <optional>

#include "drivers/measurement/measurement.hpp"

namespace drydock::bridge {

using measurement::Stamp;

/// How the body turned in the last two seconds, from an IMU's angular rates. The Earth's turn stays
/// in it: 7e-5 rad/s.
class RotationHistory {
 public:
  void add(const measurement::ImuSample& sample);

  /// The attitude at `to` as seen from the body at `from`: it turns vectors of the later body axes
  /// into the earlier ones. Empty if the samples do not reach both times.
  std::optional<Eigen::Quaterniond> between(Stamp from, Stamp to) const;

 private:
  struct Turned {
    Stamp at{};
    Eigen::Quaterniond attitude;  ///< since the first sample
    Eigen::Vector3d rate_radps;
  };

  std::optional<Eigen::Quaterniond> attitude_at(Stamp at) const;

  std::deque<Turned> turned_;  ///< in order of time
};

}  // namespace drydock::bridge

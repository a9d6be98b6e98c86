#pragma once

#include <Eigen/Core>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::sensor {

/// The effect of faults on one quantity of a sensor: docs/use/faults.md. It changes while the
/// sensor runs.
struct Disturbance {
  Eigen::Vector3d bias = Eigen::Vector3d::Zero();
  struct Drift {
    Eigen::Vector3d amount = Eigen::Vector3d::Zero();  ///< reached after `within`, then held
    measurement::Stamp since{};
    std::chrono::nanoseconds within{1};
  };
  std::optional<Drift> drift;
  double noise_times = 1;                ///< factor on the white noise
  std::optional<Eigen::Vector3d> wrong;  ///< the reading, whatever the input
  Eigen::Vector3d spike = Eigen::Vector3d::Zero();
  double spike_probability = 0;  ///< per sample
  bool stuck = false;            ///< the last error stays; the caller holds the input

  bool none() const {
    return bias.isZero(0) && !drift && !wrong && spike_probability == 0 && !stuck;
  }
};

}  // namespace drydock::sensor

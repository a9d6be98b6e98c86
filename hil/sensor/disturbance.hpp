#pragma once

#include <Eigen/Core>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::sensor {

/// What faults make of one quantity of a sensor: docs/use/faults.md. Changes while the sensor runs.
struct Disturbance {
  Eigen::Vector3d bias = Eigen::Vector3d::Zero();
  struct Drift {
    Eigen::Vector3d amount = Eigen::Vector3d::Zero();  ///< reached within `within`, then held
    measurement::Stamp since{};
    std::chrono::nanoseconds within{1};
  };
  std::optional<Drift> drift;
  double noise_times = 1;                ///< of the white noise
  std::optional<Eigen::Vector3d> wrong;  ///< what is read, whatever is there
  Eigen::Vector3d spike = Eigen::Vector3d::Zero();
  double spike_probability = 0;  ///< of each sample
  bool stuck = false;            ///< the last error stays; the input is held by who gives it

  bool none() const {
    return bias.isZero(0) && !drift && !wrong && spike_probability == 0 && !stuck;
  }
};

}  // namespace drydock::sensor

#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace drydock::pipeline {

/// An aiding sensor: its device index, and its position in the body frame from the origin of the
/// vehicle, m.
struct AidingSensor {
  std::uint16_t device = 0;
  Eigen::Vector3d lever = Eigen::Vector3d::Zero();
};

}  // namespace drydock::pipeline

#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

namespace drydock::measurement {

/// What one joint of a vehicle is told, by its name. An empty value says nothing.
struct JointOrder {
  std::string name;
  std::optional<double> position_rad{}, velocity_radps{}, effort_n{};
};

/// Force and moment on a vehicle about the origin of its body axes, forward-right-down.
struct BodyWrench {
  Eigen::Vector3d force_n = Eigen::Vector3d::Zero(), moment_nm = Eigen::Vector3d::Zero();
};

}  // namespace drydock::measurement

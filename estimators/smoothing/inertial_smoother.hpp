#pragma once

#include "estimators/navigation/aided_navigation.hpp"
#include "estimators/smoothing/track.hpp"

namespace drydock::smoothing {

/// An inertial navigation whose start and grade are known, with its aiding sensors.
struct InertialOptions {
  navigation::NavigationState start;  ///< of the origin of the vehicle, at the first IMU sample
  navigation::NavigationOptions navigation;  ///< its height loop is not used: depths aid the filter
  bool imu_means = false;  ///< samples are means over the interval before their time
  Eigen::Vector3d imu_lever = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> levers;  ///< by device
  double sea_level_m = 0;               ///< above the ellipsoid
};

/// The forward filter of 15 states and the backward smoother over its navigation steps. Readings
/// before the first and after the last IMU sample are not used, nor are logs: a log measures
/// another velocity. Epochs are steps of 0.1 s, cut where a reading is due.
Track smooth_inertial(const Dive& dive, const InertialOptions& options);

}  // namespace drydock::smoothing

#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/geodetic.hpp"
#include "estimators/smoothing/reading.hpp"

namespace drydock::smoothing {

/// The vehicle at one time of a track: its origin, WGS-84. Covariances in NED, m2 and (m/s)2.
struct TrackPoint {
  double time_s = 0;
  frame::Position position;
  Eigen::Vector3d velocity_ned = Eigen::Vector3d::Zero();
  frame::Euler attitude;
  Eigen::Matrix3d position_covariance = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d velocity_covariance = Eigen::Matrix3d::Zero();
  double heading_sigma_rad = 0;
};

/// The filter's points and the smoother's, epoch by epoch, and the filter's residuals.
struct Track {
  std::vector<TrackPoint> filtered, smoothed;
  Residuals residuals;  ///< innovations: each reading against what was known before it
  /// What the whole dive tells of the scale of bottom track, and its sigma; 0: it was no unknown.
  double bottom_scale = 0, bottom_scale_sigma = 0;
};

}  // namespace drydock::smoothing

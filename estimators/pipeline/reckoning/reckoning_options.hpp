#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "estimators/frame/geodetic.hpp"
#include "estimators/pipeline/maker.hpp"
#include "estimators/pipeline/reckoning/reckoning_filter.hpp"

namespace drydock::pipeline {

/// A device of a dead reckoning: its index, its place from the vehicle's origin, body axes, m, and
/// its axes. Only a DVL's own compass and tilt sensors need these.
struct ReckoningDevice {
  std::uint16_t index = 0;
  Eigen::Vector3d lever = Eigen::Vector3d::Zero();
  Eigen::Matrix3d sensor_to_body = Eigen::Matrix3d::Identity();
};

/// A dead reckoning without an inertial unit. All sigmas are one standard deviation.
struct ReckoningOptions {
  std::optional<ReckoningDevice> dvl, log, heading, depth, gnss;

  std::optional<frame::Position> start;  ///< of the origin; empty: at the first fix of `gnss`
  double sea_level_m = 0;                ///< height of the sea surface above the ellipsoid
  double variation_rad = 0;  ///< true minus magnetic, added to headings that are not true
  double tilt_sigma_rad = 0.0175, depth_sigma_m = 0.5;
  double fix_sigma_m = 5;  ///< of a fix without accuracy
  ReckoningErrors errors;
  /// A longer time without speed or heading is a gap, and an older heading is not used.
  double gap_s = 5;
};

std::string fault_of(const ReckoningOptions& options);
std::unique_ptr<Estimator> make_estimator(Seat seat, const ReckoningOptions& options,
                                          const PipelineOptions& pipeline);

}  // namespace drydock::pipeline

#pragma once

#include <optional>

#include "estimators/smoothing/inertial_smoother.hpp"
#include "estimators/smoothing/level_filter.hpp"
#include "hil/track/gathered.hpp"

namespace drydock::track {

/// An inertial navigation of the rig: what its estimator says of start, grade and sensors.
struct InertialSetup {
  std::string estimator;
  std::uint16_t imu = 0;
  smoothing::InertialOptions options;
  double bottom_sigma_mps = 0, depth_sigma_m = 0, heading_sigma_rad = 0, fix_sigma_m = 0;
};

/// The rig's first estimator that navigates inertially. Empty: it has none.
std::optional<InertialSetup> inertial_of(const rig_config::Rig& rig);

/// The model without an inertial unit, at the start of the dive. Without a fix the track begins at
/// `origin`, which then is exact.
smoothing::LevelOptions level_of(const Gathered& gathered, const frame::Position& origin);

bool has(const smoothing::Dive& dive, smoothing::Quantity quantity);
/// A depth, a velocity with its vertical axis, or the height of a fix.
bool tells_height(const smoothing::Dive& dive);

}  // namespace drydock::track

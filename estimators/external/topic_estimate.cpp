#include "estimators/external/topic_estimate.hpp"

#include <limits>

#include "estimators/external/values.hpp"

namespace drydock::external {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

Matrix3d or_absent(const std::optional<Matrix3d>& covariance) {
  return covariance.value_or(Matrix3d::Constant(absent));
}

frame::Position position_of(const bus::OutsideValues& values, const frame::Position& origin) {
  if (values.geodetic) return {values.geodetic->x(), values.geodetic->y(), values.geodetic->z()};
  if (values.offset_ned_m) return frame::at_ned_offset(origin, *values.offset_ned_m);
  return {absent, absent, absent};
}

}  // namespace

bool has_what_it_gives(const bus::OutsideValues& values, Gives gives) {
  if (gives == Gives::attitude) return values.body_to_ned.has_value();
  if (gives == Gives::velocity) return values.velocity_ned_mps.has_value();
  return values.geodetic || values.offset_ned_m;
}

pipeline::OutsideEstimate estimate_of(const bus::OutsideValues& values, Gives gives,
                                      const frame::Position& origin) {
  pipeline::NavigationEstimate estimate;
  estimate.valid_at = values.valid_at;
  estimate.position = position_of(values, origin);
  estimate.velocity_ned = values.velocity_ned_mps.value_or(Vector3d::Constant(absent));
  estimate.body_to_ned =
      values.body_to_ned.value_or(Eigen::Quaterniond{absent, absent, absent, absent});
  estimate.covariance.topLeftCorner<3, 3>() = or_absent(values.position_m2);
  estimate.covariance.block<3, 3>(3, 3) = or_absent(values.velocity_m2ps2);
  estimate.covariance.bottomRightCorner<3, 3>() = or_absent(values.rotation_rad2);
  set_bounds(estimate);
  if (gives == Gives::attitude) return pipeline::attitude_of(estimate);
  return estimate;
}

}  // namespace drydock::external

#include "estimators/pipeline/fix_timing.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/measurement/axis_sigma.hpp"

namespace drydock::pipeline {

using measurement::GnssFix;
using measurement::seconds;

namespace {

/// A lateness that lasts is forgotten in this time, because the errors of the velocity add up.
constexpr double forgotten_in_s = 60;

/// Between fixes that are further apart the mean of their velocities is not that of the way.
constexpr double longest_way_s = 5;

/// One sigma of a position whose accuracy is not told, m; so many sigmas are noise.
constexpr double common_sigma_m = 2, noise_sigmas = 4;

std::optional<double> height_of(const GnssFix& fix) {
  return fix.ellipsoidal_height_m ? fix.ellipsoidal_height_m : fix.mean_sea_level_height_m;
}

}  // namespace

void FixTiming::add(const GnssFix& fix, const Eigen::Vector3d& velocity_ned) {
  const auto height = height_of(fix);
  if (!fix.position || !height) return;
  const Place now{fix.origin.valid_at,
                  {fix.position->latitude_rad, fix.position->longitude_rad, *height},
                  velocity_ned};
  const double told_s = last_ ? seconds(now.at - last_->at) : 0;
  if (told_s > 0 && told_s <= longest_way_s) {
    const Eigen::Vector3d mean = (velocity_ned + last_->velocity_ned) / 2;
    const Eigen::Vector3d way = frame::ned_offset(last_->position, now.position);
    late_s_ =
        std::exp(-told_s / forgotten_in_s) * late_s_ + told_s - way.dot(mean) / mean.squaredNorm();
  }
  noise_s_ = measurement::axis_sigma_m(fix).value_or(common_sigma_m) / velocity_ned.norm();
  last_ = now;
}

double FixTiming::variance() const {
  return std::max(0.0, late_s_ * late_s_ - std::pow(noise_sigmas * noise_s_, 2));
}

}  // namespace drydock::pipeline

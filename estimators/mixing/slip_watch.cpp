#include "estimators/mixing/slip_watch.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace drydock::mixing {

using Eigen::Vector3d;

namespace {

/// One sigma of what a straight way leaves unexplained, m/s. Ahead the log's scale and its pace add
/// to it. Chosen.
constexpr double ahead_mps = 0.05, across_mps = 0.03;

/// A vehicle that begins to turn slips: it turns about a point up to so far ahead of its IMU.
constexpr double pivot_m = 2.5;

}  // namespace

void SlipWatch::start(double speed_mps) {
  slip_.setZero();
  rate_.setZero();
  slow_rate_.setZero();
  speed_mps_ = speed_mps;
}

void SlipWatch::step(const Vector3d& force, const Vector3d& rate, const Vector3d& down,
                     double speed_mps, double dt) {
  const Vector3d velocity{speed_mps, slip_.y(), slip_.z()};
  const Vector3d gained = force + gravity_ * down - rate.cross(velocity);
  slip_ += dt * (gained - slip_ / span_s_);
  slip_.x() -= speed_mps - speed_mps_;
  speed_mps_ = speed_mps;
  slow_rate_ += dt / span_s_ * (rate - slow_rate_);
  rate_ = rate;
}

bool SlipWatch::contradicts(double tilt_sigma_rad) const {
  const double by_tilt = gravity_ * span_s_ * tilt_sigma_rad;
  const auto with_tilt = [&](double own) { return std::sqrt(own * own + by_tilt * by_tilt); };
  const double ahead = with_tilt(ahead_mps), across = with_tilt(across_mps);
  const Vector3d begun = pivot_m * (rate_ - slow_rate_).cwiseAbs();
  const Vector3d allowed =
      limit * Vector3d{ahead, across, across} + Vector3d{0, begun.z(), begun.y()};
  return !(slip_.cwiseAbs().array() <= allowed.array()).all();  // true for NaN too
}

}  // namespace drydock::mixing

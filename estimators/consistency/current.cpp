#include "estimators/consistency/current.hpp"

#include <cmath>

namespace drydock::consistency {
namespace {

constexpr double first_current_mps = 0.5;                     // 1 sigma
constexpr double current_walk = 0.004, offset_walk = 0.0005;  // m/s/sqrt(s)
constexpr double noise_mps = 0.1;                             // of one comparison
constexpr double unlikely = 6;                                // sigmas; no water does that

double squared(double x) { return x * x; }

}  // namespace

Current::Current(double offset_sigma_mps)
    : covariance_(Eigen::Vector4d(squared(first_current_mps), squared(first_current_mps),
                                  squared(offset_sigma_mps), squared(offset_sigma_mps))
                      .asDiagonal()) {}

Current::Row Current::row(int axis, double heading) {
  const double c = std::cos(heading), s = std::sin(heading);
  return axis == 0 ? Row(c, s, 1, 0) : Row(-s, c, 0, 1);
}

Eigen::Vector2d Current::at(double heading) const {
  return {row(0, heading).dot(state_), row(1, heading).dot(state_)};
}

Eigen::Vector2d Current::water_at(double heading) const { return at(heading) - state_.tail<2>(); }

double Current::offset_sigma() const { return std::sqrt(covariance_(2, 2)); }

double Current::variance(double heading) const {
  const Row h = row(0, heading);
  return (h * covariance_ * h.transpose()).value();
}

void Current::follow(const Eigen::Vector2d& lacking, bool across, double heading, double dt) {
  covariance_.diagonal() += dt * Eigen::Vector4d(squared(current_walk), squared(current_walk),
                                                 squared(offset_walk), squared(offset_walk));
  update(lacking.x(), row(0, heading));
  if (across) update(lacking.y(), row(1, heading));
}

void Current::update(double lacking, const Row& h) {
  const Eigen::Vector4d ph = covariance_ * h.transpose();
  const double variance = h.dot(ph) + squared(noise_mps);
  const double news = lacking - h.dot(state_);
  if (squared(news) > squared(unlikely) * variance) return;
  state_ += ph * (news / variance);
  covariance_ -= ph * ph.transpose() / variance;
}

}  // namespace drydock::consistency

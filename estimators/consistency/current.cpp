#include "estimators/consistency/current.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace drydock::consistency {
namespace {

constexpr double first_s = 2, later_s = 30;  // time constants at first and later
constexpr double fastest = 0.006;            // m/s2: a change of the current along the way
constexpr double own_share = 0.3;            // the log's own offset changes more slowly

Eigen::Vector2d bounded(const Eigen::Vector2d& step, double most) {
  return step * std::min(1.0, most / std::max(step.norm(), 1e-12));
}

}  // namespace

Eigen::Vector2d Current::along(std::optional<double> heading) const {
  return Eigen::Rotation2Dd(-heading.value_or(0)) * earth_ + own_;
}

void Current::follow(const Eigen::Vector2d& error, std::optional<double> heading, double dt) {
  followed_s_ += dt;
  const double memory_s = std::clamp(followed_s_, first_s, later_s);
  const double most = followed_s_ < later_s ? 1e3 : fastest * dt;
  const Eigen::Vector2d step = bounded(error * std::min(1.0, dt / memory_s), most);
  earth_ += Eigen::Rotation2Dd(heading.value_or(0)) * step;
  own_ += own_share * step;
}

}  // namespace drydock::consistency

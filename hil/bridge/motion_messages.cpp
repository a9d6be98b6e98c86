#include "hil/bridge/motion_messages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drydock::bridge {

namespace {

using measurement::BottomVelocity;
namespace mavlink = wire::mavlink;

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

std::array<float, 3> floats(const Eigen::Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

std::chrono::microseconds microseconds(std::chrono::nanoseconds time) {
  return std::chrono::round<std::chrono::microseconds>(time);
}

/// In percent, as confidence and quality count.
double quality_of(const BottomVelocity& ping) {
  const auto sigma_mps = sigma_of(ping);
  return sigma_mps ? confidence_of(*sigma_mps) : 100;
}

/// The rows of the velocity; those of the rates are unknown.
std::array<float, 21> velocity_covariance(const BottomVelocity& ping) {
  std::array<float, 21> triangle{};
  std::fill(triangle.begin() + 15, triangle.end(), unknown);
  const auto sigma_mps = sigma_of(ping);
  if (!sigma_mps) {
    triangle[0] = unknown;
    return triangle;
  }
  const Eigen::Matrix3d c = ping.velocity_covariance.value_or(
      Eigen::Matrix3d(*sigma_mps * *sigma_mps * Eigen::Matrix3d::Identity()));
  std::size_t at = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = row; column < 6; ++column, ++at)
      if (column < 3) triangle[at] = static_cast<float>(c(row, column));
  return triangle;
}

}  // namespace

mavlink::VisionPositionDelta position_delta(const BottomVelocity& ping, const Moved& moved) {
  mavlink::VisionPositionDelta message;
  message.time = microseconds(moved.to.time_since_epoch());
  message.time_delta = microseconds(moved.time);
  message.angle_rad = floats(moved.angle_rad);
  message.position_m = floats(moved.position_m);
  message.confidence = static_cast<float>(quality_of(ping));
  return message;
}

mavlink::Odometry odometry(const BottomVelocity& ping, const Moved& moved) {
  mavlink::Odometry message;
  message.time = microseconds(moved.to.time_since_epoch());
  message.position_m.fill(unknown);
  message.attitude.fill(unknown);
  message.velocity_mps = floats(*ping.velocity);
  message.rates_radps.fill(unknown);
  if (moved.rotation_known)
    message.rates_radps = floats(moved.angle_rad / measurement::seconds(moved.time));
  message.pose_covariance[0] = unknown;
  message.velocity_covariance = velocity_covariance(ping);
  message.quality = static_cast<std::int8_t>(std::clamp(std::lround(quality_of(ping)), 1L, 100L));
  return message;
}

std::optional<double> sigma_of(const BottomVelocity& ping) {
  if (ping.velocity_covariance) return std::sqrt(ping.velocity_covariance->trace() / 3);
  return ping.figure_of_merit_mps;
}

double confidence_of(double sigma_mps) {
  constexpr double best_mps = 0.1, worst_mps = 0.9;
  return std::clamp(100 * (worst_mps - sigma_mps) / (worst_mps - best_mps), 0.0, 100.0);
}

}  // namespace drydock::bridge

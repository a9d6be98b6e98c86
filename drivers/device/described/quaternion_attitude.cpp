#include "drivers/device/described/quaternion_attitude.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace drydock::device {
namespace {

using wire::described::Readings;
using wire::described::Target;
using enum wire::described::Target;

constexpr double length_error = 0.02;  ///< more than rounding to 8 bits makes

/// The four targets from the scalar part on.
std::optional<Eigen::Quaterniond> quaternion(const Readings& r, Target scalar) {
  Eigen::Vector4d parts;
  for (int i = 0; i < 4; ++i) {
    const auto part = r.get(static_cast<Target>(static_cast<int>(scalar) + i));
    if (!part) return {};
    parts[i] = *part;
  }
  return Eigen::Quaterniond(parts[0], parts[1], parts[2], parts[3]);
}

/// East, north, up <- forward, port, up becomes north, east, down <- forward, starboard, down: a
/// half turn about north-east before, and one about forward behind.
Eigen::Quaterniond to_ned(const Eigen::Quaterniond& enu) {
  const double half = std::sqrt(0.5);
  return Eigen::Quaterniond(0, half, half, 0) * enu * Eigen::Quaterniond(0, -1, 0, 0);
}

void set_if_absent(Readings& readings, Target target, double value) {
  if (!readings.has(target)) readings.set(target, value);
}

std::optional<Eigen::Quaterniond> body_to_ned(const Readings& r) {
  if (auto ned = quaternion(r, quaternion_w)) return ned;
  if (const auto enu = quaternion(r, enu_quaternion_w)) return to_ned(*enu);
  return {};
}

}  // namespace

std::optional<Readings> with_angles(const Readings& readings) {
  const auto turned = body_to_ned(readings);
  if (!turned || !(std::abs(turned->norm() - 1) <= length_error)) return {};
  const Eigen::Matrix3d axes = turned->normalized().toRotationMatrix();
  const double yaw = std::atan2(axes(1, 0), axes(0, 0));
  Readings result = readings;
  set_if_absent(result, roll, std::atan2(axes(2, 1), axes(2, 2)));
  set_if_absent(result, pitch, std::asin(std::clamp(-axes(2, 0), -1.0, 1.0)));
  if (!readings.has(magnetic_heading))
    set_if_absent(result, heading, yaw < 0 ? yaw + 2 * std::numbers::pi : yaw);
  return result;
}

bool has_quaternion(const Readings& readings) { return body_to_ned(readings).has_value(); }

}  // namespace drydock::device

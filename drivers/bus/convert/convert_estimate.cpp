#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "drivers/bus/convert/convert.hpp"
#include "drivers/bus/owned.hpp"

namespace drydock::bus {
namespace {

/// REP-103 measures yaw counter-clockwise from east; Drydock measures it clockwise from north. A
/// half turn of the body about x keeps roll and reverses pitch.
constexpr double quarter_turn = std::numbers::pi / 2;

Eigen::Quaterniond from_euler(double roll, double pitch, double yaw) {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

double yaw_in_turn(double yaw) { return std::remainder(yaw, 2 * std::numbers::pi); }

void fill(diagnostic_msgs_msg_dds__DiagnosticStatus_& status, const DeviceStatus& from) {
  status.level = static_cast<std::uint8_t>(from.level);
  status.name = copy_of(from.name);
  status.message = copy_of(from.message);
  status.hardware_id = copy_of(from.hardware_id);
  auto* next = allocate(status.values, from.values.size());
  for (const auto& [key, value] : from.values) *next++ = {copy_of(key), copy_of(value)};
}

}  // namespace

bool fill(ImuMessage& message, const Attitude& attitude) {
  message.header.stamp = to_time(attitude.valid_at);
  const auto q = from_euler(attitude.roll_rad, -attitude.pitch_rad,
                            quarter_turn - attitude.yaw_rad.value_or(0));
  message.orientation = {q.x(), q.y(), q.z(), q.w()};
  auto& covariance = message.orientation_covariance;
  std::ranges::fill(covariance, 0.0);
  covariance[0] = attitude.covariance(0, 0);
  covariance[1] = -attitude.covariance(0, 1);
  covariance[3] = -attitude.covariance(1, 0);
  covariance[4] = attitude.covariance(1, 1);
  covariance[8] = attitude.yaw_rad ? 0 : unknown_variance;
  message.angular_velocity_covariance[0] = -1;
  message.linear_acceleration_covariance[0] = -1;
  return true;
}

bool read(Attitude& attitude, const ImuMessage& message) {
  const auto& [x, y, z, w] = message.orientation;
  const Eigen::Quaterniond raw(w, x, y, z);
  if (message.orientation_covariance[0] < 0 || !(std::abs(raw.norm() - 1) < 0.01)) return false;
  const Eigen::Matrix3d r = raw.normalized().toRotationMatrix();
  attitude.valid_at = to_stamp(message.header.stamp);
  attitude.roll_rad = std::atan2(r(2, 1), r(2, 2));
  attitude.pitch_rad = std::atan2(r(2, 0), std::hypot(r(2, 1), r(2, 2)));
  const auto& covariance = message.orientation_covariance;
  if (covariance[8] < unknown_variance) {
    attitude.yaw_rad = yaw_in_turn(quarter_turn - std::atan2(r(1, 0), r(0, 0)));
  }
  attitude.covariance << covariance[0], -covariance[1], -covariance[3], covariance[4];
  return attitude.covariance.allFinite();
}

void fill(DiagnosticsMessage& message, std::span<const DeviceStatus> health, Stamp now) {
  release_but_frame(message);
  message.header.stamp = to_time(now);
  auto* next = allocate(message.status, health.size());
  for (const auto& device : health) fill(*next++, device);
}

DeviceStatus read(const diagnostic_msgs_msg_dds__DiagnosticStatus_& status) {
  DeviceStatus device{static_cast<Level>(std::min<std::uint8_t>(status.level, 3)),
                      status.name,
                      status.message,
                      status.hardware_id,
                      {}};
  for (std::uint32_t i = 0; i < status.values._length; ++i) {
    device.values.emplace_back(status.values._buffer[i].key, status.values._buffer[i].value);
  }
  return device;
}

}  // namespace drydock::bus

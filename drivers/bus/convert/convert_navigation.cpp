#include <algorithm>
#include <cmath>

#include "drivers/bus/convert/convert.hpp"
#include "drivers/measurement/units.hpp"

namespace drydock::bus {
namespace {

constexpr std::int8_t has_fix = 0, dead_reckoned_service = 0;
constexpr std::uint8_t covariance_known = 3, covariance_unknown = 0;

/// Converts rotations. A product with it would spread a number that is not known (NaN).
Eigen::Matrix3d ned_to_enu() {
  Eigen::Matrix3d m;
  m << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  return m;
}

Eigen::Matrix3d block(const Navigation& navigation, int row, int column) {
  return navigation.covariance.block<3, 3>(3 * row, 3 * column);
}

/// Adding 0 makes 0 of -0.
Eigen::Vector3d enu_of(const Eigen::Vector3d& ned) { return swap_ned_enu(ned).array() + 0.0; }

Eigen::Matrix3d enu_block(const Navigation& navigation, int row, int column) {
  Eigen::Matrix3d both = block(navigation, row, column);
  for (int i = 0; i < 3; ++i) both.col(i) = enu_of(both.col(i));
  for (int i = 0; i < 3; ++i) both.row(i) = enu_of(both.row(i).transpose()).transpose();
  return both;
}

void set(double (&covariance)[36], int row, int column, const Eigen::Matrix3d& values) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) covariance[6 * (3 * row + i) + 3 * column + j] = values(i, j);
}

/// What is not known becomes the largest variance, which depends on nothing. Odometry has no sign
/// for it: robot_localization takes the amount of a variance below 0, takes 0 as exact, and loses
/// its state by a NaN.
void replace_unknown(double (&covariance)[36]) {
  Eigen::Map<Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> all(covariance);
  for (int i = 0; i < 6; ++i) {
    if (std::isfinite(all(i, i))) continue;
    all.row(i).setZero();
    all.col(i).setZero();
    all(i, i) = unknown_variance;
  }
  all = all.unaryExpr([](double value) { return std::isfinite(value) ? value : 0.0; });
}

}  // namespace

bool fill(OdometryMessage& message, const Navigation& navigation) {
  enum Block { position, velocity, rotation };
  const Eigen::Matrix3d frd_to_flu = Eigen::Vector3d{1, -1, -1}.asDiagonal();
  const Eigen::Matrix3d body_to_ned = navigation.body_to_ned.toRotationMatrix();
  message.header.stamp = to_time(navigation.valid_at);

  const Eigen::Vector3d at = enu_of(navigation.offset_ned);
  const Eigen::Quaterniond q(ned_to_enu() * body_to_ned * frd_to_flu);
  message.pose.pose.position = {at.x(), at.y(), at.z()};
  message.pose.pose.orientation = {q.x(), q.y(), q.z(), q.w()};
  set(message.pose.covariance, 0, 0, enu_block(navigation, position, position));
  set(message.pose.covariance, 0, 1, enu_block(navigation, position, rotation));
  set(message.pose.covariance, 1, 0, enu_block(navigation, rotation, position));
  set(message.pose.covariance, 1, 1, enu_block(navigation, rotation, rotation));
  replace_unknown(message.pose.covariance);

  const Eigen::Matrix3d ned_to_flu = frd_to_flu * body_to_ned.transpose();
  const Eigen::Vector3d v = ned_to_flu * navigation.velocity_ned;
  message.twist.twist = {};
  message.twist.twist.linear = to_vector3(v);
  std::ranges::fill(message.twist.covariance, 0.0);
  set(message.twist.covariance, 0, 0,
      ned_to_flu * block(navigation, velocity, velocity) * ned_to_flu.transpose());
  set(message.twist.covariance, 1, 1, unknown_variance * Eigen::Matrix3d::Identity());
  replace_unknown(message.twist.covariance);
  return true;
}

bool fill(NavSatFixMessage& message, const Navigation& navigation) {
  message.header.stamp = to_time(navigation.valid_at);
  message.status = {has_fix, dead_reckoned_service};
  message.latitude = navigation.latitude_rad * units::degrees_per_radian;
  message.longitude = navigation.longitude_rad * units::degrees_per_radian;
  message.altitude = navigation.height_m;
  Eigen::Matrix3d enu = enu_block(navigation, 0, 0);
  const bool known = enu.topLeftCorner<2, 2>().allFinite();
  if (!known) enu.setZero();
  if (!enu.allFinite()) {  // of a height that nobody tells: it gets no weight
    enu.row(2).setZero();
    enu.col(2).setZero();
    enu(2, 2) = unknown_variance;
  }
  for (int i = 0; i < 9; ++i) message.position_covariance[i] = enu(i / 3, i % 3);
  message.position_covariance_type = known ? covariance_known : covariance_unknown;
  return true;
}

}  // namespace drydock::bus

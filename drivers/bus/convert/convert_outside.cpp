#include "drivers/bus/convert/convert_outside.hpp"

#include <algorithm>
#include <numbers>
#include <string_view>

#include "drivers/bus/convert/convert.hpp"
#include "drivers/measurement/covariance.hpp"
#include "drivers/measurement/units.hpp"

namespace drydock::bus {
namespace {

using Eigen::Matrix3d;
using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

const Matrix3d enu_to_ned{{0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
const Matrix3d frd_to_flu_axes = Eigen::Vector3d{1, -1, -1}.asDiagonal();

Matrix3d turned(const Matrix3d& by, const Matrix3d& covariance) {
  return by * covariance * by.transpose();
}

/// The variance of a heading that is not known; any more says no more.
constexpr double any_heading_rad2 = std::numbers::pi * std::numbers::pi / 3;

/// ROS says "not known" as zeros, as a variance of -1, or as a very large one.
std::optional<Matrix3d> known(const Matrix3d& covariance) {
  const auto d = covariance.diagonal().array();
  const bool is_known =
      covariance.allFinite() && (d >= 0).all() && (d > 0).any() && (d < unknown_variance).all();
  return is_known ? std::optional(covariance) : std::nullopt;
}

/// Block 0 or 1 on the diagonal of a covariance of six numbers.
Matrix3d block_of(const double (&covariance)[36], int block) {
  const Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> all(covariance);
  return all.block<3, 3>(3 * block, 3 * block);
}

/// False if it is known and no covariance.
bool turn_known(std::optional<Matrix3d>& to, const Matrix3d& by, const Matrix3d& covariance) {
  const auto found = known(covariance);
  if (found) to = turned(by, *found);
  return !found || measurement::covariance_flaw(*found) == nullptr;
}

/// From a rotation of the body (FLU) to ENU; empty if it is none.
std::optional<Eigen::Quaterniond> body_to_ned(const geometry_msgs_msg_dds__Quaternion_& q) {
  const Eigen::Quaterniond raw(q.w, q.x, q.y, q.z);
  if (!(std::abs(raw.norm() - 1) < 0.01)) return {};
  return Eigen::Quaterniond(enu_to_ned * raw.normalized().toRotationMatrix() * frd_to_flu_axes);
}

bool read_pose(OutsideValues& values, const geometry_msgs_msg_dds__PoseWithCovariance_& pose) {
  const auto& at = pose.pose.position;
  values.body_to_ned = body_to_ned(pose.pose.orientation);
  values.offset_ned_m = swap_ned_enu({at.x, at.y, at.z});
  return turn_known(values.position_m2, enu_to_ned, block_of(pose.covariance, 0)) &&
         turn_known(values.rotation_rad2, enu_to_ned, block_of(pose.covariance, 1)) &&
         values.body_to_ned && values.offset_ned_m->allFinite();
}

bool is_east_north_up(std::string_view frame) {
  return frame == "map" || frame == "odom" || frame == "world" || frame.ends_with("_enu");
}

bool set_velocity(OutsideValues& values, const geometry_msgs_msg_dds__TwistWithCovariance_& twist,
                  const Matrix3d& to_ned) {
  values.velocity_ned_mps = to_ned * to_eigen(twist.twist.linear);
  return turn_known(values.velocity_m2ps2, to_ned, block_of(twist.covariance, 0)) &&
         values.velocity_ned_mps->allFinite();
}

}  // namespace

bool read(OutsideValues& values, const ImuMessage& message) {
  values.valid_at = to_stamp(message.header.stamp);
  if (message.orientation_covariance[0] < 0) return false;
  values.body_to_ned = body_to_ned(message.orientation);
  if (!values.body_to_ned) return false;
  // The variances of this message are those of roll, pitch and yaw: those of a level vehicle about
  // its own axes, which its heading turns to north and east.
  const Matrix3d in_body{{message.orientation_covariance[0], message.orientation_covariance[1], 0},
                         {message.orientation_covariance[3], message.orientation_covariance[4], 0},
                         {0, 0, std::min(message.orientation_covariance[8], any_heading_rad2)}};
  const Matrix3d flu_to_ned = values.body_to_ned->toRotationMatrix() * frd_to_flu_axes;
  return turn_known(values.rotation_rad2, flu_to_ned, in_body);
}

bool read(OutsideValues& values, const OdometryMessage& message) {
  values.valid_at = to_stamp(message.header.stamp);
  if (!read_pose(values, message.pose)) return false;
  return set_velocity(values, message.twist,
                      values.body_to_ned->toRotationMatrix() * frd_to_flu_axes);
}

bool read(OutsideValues& values, const PoseMessage& message) {
  values.valid_at = to_stamp(message.header.stamp);
  return read_pose(values, message.pose);
}

bool read(OutsideValues& values, const TwistMessage& message) {
  values.valid_at = to_stamp(message.header.stamp);
  return is_east_north_up(message.header.frame_id) &&
         set_velocity(values, message.twist, enu_to_ned);
}

bool read(OutsideValues& values, const NavSatFixMessage& message) {
  values.valid_at = to_stamp(message.header.stamp);
  if (message.status.status < 0) return false;
  values.geodetic = Eigen::Vector3d{message.latitude * units::degree,
                                    message.longitude * units::degree, message.altitude};
  if (message.position_covariance_type != 0 &&
      !turn_known(values.position_m2, enu_to_ned,
                  Eigen::Map<const Rows>(message.position_covariance)))
    return false;
  return values.geodetic->head<2>().allFinite() && std::abs(message.latitude) <= 90;
}

}  // namespace drydock::bus

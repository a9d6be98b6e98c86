#include "hil/replay/recorded_truth.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "drivers/measurement/units.hpp"
#include "hil/replay/reference/references.hpp"

namespace drydock::replay {

namespace {

constexpr double quarter_turn = std::numbers::pi / 2;

using Values = std::map<std::string, double>;

Eigen::Vector3d vector_of(const Values& v, const std::string& name) {
  return {v.at(name + ".x"), v.at(name + ".y"), v.at(name + ".z")};
}

/// The body's axes (forward, left, up) in east, north, up, as orientations in docs/build/bus.md.
Eigen::Matrix3d axes_of(const Values& v, const std::string& name) {
  return Eigen::Quaterniond(v.at(name + ".w"), v.at(name + ".x"), v.at(name + ".y"),
                            v.at(name + ".z"))
      .normalized()
      .toRotationMatrix();
}

/// Converts between east-north-up and north-east-down, in both directions.
Eigen::Vector3d swapped(const Eigen::Vector3d& v) { return {v.y(), v.x(), -v.z()}; }

bus::Attitude attitude_of(const Values& v, measurement::Stamp at) {
  const auto r = axes_of(v, "orientation");
  return {.valid_at = at,
          .roll_rad = std::atan2(r(2, 1), r(2, 2)),
          .pitch_rad = std::atan2(r(2, 0), std::hypot(r(2, 1), r(2, 2))),
          .yaw_rad = quarter_turn - std::atan2(r(1, 0), r(0, 0)),
          .covariance = Eigen::Matrix2d::Zero()};
}

/// All fields except latitude, longitude and height.
bus::Navigation navigation_of(const Values& v, measurement::Stamp at) {
  const auto axes = axes_of(v, "pose.pose.orientation");
  Eigen::Matrix3d body_to_ned;
  for (int i = 0; i < 3; ++i)
    body_to_ned.col(i) = swapped(axes.col(i)) * (i == 0 ? 1 : -1);  // left and up become right and
                                                                    // down
  bus::Navigation n;
  n.valid_at = at;
  n.offset_ned = swapped(vector_of(v, "pose.pose.position"));
  n.velocity_ned = swapped(axes * vector_of(v, "twist.twist.linear"));
  n.body_to_ned = Eigen::Quaterniond(body_to_ned);
  return n;
}

}  // namespace

std::map<std::string, double> RecordedTruth::values(const record::Understood& message) {
  const record::Layout& layout = layouts_.of(message);
  Values all;
  if (!layout) return all;
  for (const auto& [name, value] : values_of(*layout, message.cdr))
    if (value.is_number()) all[name] = value.get<double>();
  return all;
}

/// A message of another program may have this topic and other fields: it is no truth.
void RecordedTruth::hear(const record::Understood& message) {
  const auto& topic = message.channel->topic;
  if (!topic.starts_with("/estimate/truth")) return;
  const auto v = values(message);
  if (v.empty()) return;
  try {
    take(topic, v, message.at);
  } catch (const std::out_of_range&) {  // of Values::at
  }
}

/// For one time the truth comes as attitude, odometry, fix.
void RecordedTruth::take(const std::string& topic, const Values& v, measurement::Stamp at) {
  if (topic == "/estimate/truth") {
    const auto attitude = attitude_of(v, at);
    tell();
    truth_.emplace().attitude = attitude;
  } else if (topic == "/estimate/truth/odometry") {
    navigation_ = navigation_of(v, at);
  } else if (topic == "/estimate/truth/fix" && at == navigation_.valid_at && truth_) {
    navigation_.latitude_rad = v.at("latitude") / units::degrees_per_radian;
    navigation_.longitude_rad = v.at("longitude") / units::degrees_per_radian;
    navigation_.height_m = v.at("altitude");
    truth_->navigation = navigation_;
    tell();
  }
}

void RecordedTruth::tell() {
  if (const auto truth = std::exchange(truth_, {})) to_.on_truth(*truth);
}

}  // namespace drydock::replay

#include "hil/score/message_state.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "drivers/measurement/units.hpp"
#include "drivers/text/printable.hpp"
#include "hil/score/attitude.hpp"
#include "hil/score/axes.hpp"
#include "hil/score/geodetic_place.hpp"
#include "hil/score/known_covariance.hpp"
#include "hil/score/turned.hpp"

namespace drydock::score {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Reads one message, part by part.
class Reader {
 public:
  Reader(const MessageValues& values, const frame::Position& origin)
      : values_(values), origin_(origin) {
    const auto whole = static_cast<std::int64_t>(values.at("header.stamp.sec"));
    const auto rest = static_cast<std::int64_t>(values.at("header.stamp.nanosec"));
    read_.state.at = measurement::stamp_from_ns(whole * 1'000'000'000 + rest);
  }

  Reader& position() {
    state().position_ned = turned_vector(enu_to_ned, values_.vector("pose.pose.position"));
    if (tells(state().position_ned))
      state().position_m2 = turned(enu_to_ned, known("position", of_six("pose.covariance", 0)));
    return *this;
  }

  /// The variances are those of turns about east, north, up.
  Reader& attitude() {
    if (!orientation("pose.pose.orientation")) return *this;
    const Matrix3d turns = of_six("pose.covariance", 3);
    const auto covariance = known("attitude", turns);
    if (covariance && covariance->allFinite())
      state().angles_rad2 = turned(angles_by_turns(state().angles) * enu_to_ned, covariance);
    const auto nothing = angles_of_nothing(turns, read_.default_attitude);
    for (Eigen::Index i = 0; i < 3; ++i)
      if (nothing.at(static_cast<std::size_t>(i))) forget_angle(i);
    return *this;
  }

  /// The variances are those of roll, pitch, yaw.
  Reader& level() {
    const Matrix3d variances = values_.block("orientation_covariance", 3, 0);
    if (variances(0, 0) < 0) {
      remark("it gives no orientation (its covariance begins with -1)");
    } else if (orientation("orientation")) {
      state().angles_rad2 = turned(flu_to_frd, known("attitude", variances));
      for (Eigen::Index i = 0; i < 3; ++i)
        if (is_of_nothing(variances(i, i))) forget_angle(i);
    }
    return *this;
  }

  /// Along forward, left, up.
  Reader& body_velocity() {
    velocity(flu_to_frd);
    state().velocity_in_body = true;
    return *this;
  }

  Reader& velocity_in_its_frame() {
    const auto& frame = values_.frame;
    if (frame == "map" || frame == "odom" || frame == "world" || frame.ends_with("_enu")) {
      velocity(enu_to_ned);
      return *this;
    }
    if (!frame.starts_with("base_link"))
      remark(fmt::format("its frame \"{}\" is taken for the body's: forward, left, up",
                         text::printable(frame)));
    return body_velocity();
  }

  Reader& fix() {
    const double latitude = values_.at("latitude"), longitude = values_.at("longitude");
    if (values_.at("status.status") < 0) {
      remark("it says that there is no fix");
    } else if (std::abs(latitude) > 90 || std::abs(longitude) > 360) {
      remark("its latitude or longitude is none");
    } else {
      state().position_ned = place_of(
          {latitude * units::degree, longitude * units::degree, values_.at("altitude")}, origin_);
      if (values_.at("position_covariance_type") != 0)
        state().position_m2 =
            turned(enu_to_ned, known("position", values_.block("position_covariance", 3, 0)));
    }
    return *this;
  }

  MessageState result() {
    if (!state().says_anything() && read_.remarks.empty()) remark("none of its numbers is finite");
    return std::move(read_);
  }

 private:
  State& state() { return read_.state; }
  void remark(std::string what) { read_.remarks.push_back(std::move(what)); }
  static bool tells(const Vector3d& v) { return !v.array().isNaN().all(); }
  Matrix3d of_six(const char* covariance, int first) const {
    return values_.block(covariance, 6, first);
  }

  std::optional<Matrix3d> known(const char* of, const Matrix3d& covariance) {
    const auto found = known_covariance(covariance);
    if (!found.matrix) remark(fmt::format("the covariance of its {} {}", of, found.flaw));
    return found.matrix;
  }

  bool orientation(const std::string& name) {
    const Eigen::Quaterniond q(values_.at(name + ".w"), values_.at(name + ".x"),
                               values_.at(name + ".y"), values_.at(name + ".z"));
    if (q.coeffs().hasNaN()) return false;
    if (!(std::abs(q.norm() - 1) < 0.01)) {
      remark("it gives no attitude (the quaternion's length is not 1)");
      return false;
    }
    read_.default_attitude = q.w() == 1;
    state().angles = angles_of(ned_of_enu(q));
    return true;
  }

  void forget_angle(Eigen::Index i) {
    state().angles[i] = untold()[i];
    if (state().angles_rad2) (*state().angles_rad2)(i, i) = untold()[i];
  }

  void velocity(const Matrix3d& by) {
    Vector3d linear = values_.vector("twist.twist.linear");
    const Matrix3d covariance = of_six("twist.covariance", 0);
    read_.default_velocity = linear.isZero(0) && covariance.isZero(0);
    for (Eigen::Index i = 0; i < 3; ++i)
      if (covariance(i, i) < 0) linear[i] = untold()[i];
    state().velocity = turned_vector(by, linear);
    if (tells(state().velocity)) state().velocity_m2ps2 = turned(by, known("velocity", covariance));
  }

  const MessageValues& values_;
  const frame::Position& origin_;
  MessageState read_;
};

// What a type is made of: a message of its name may have another definition.
constexpr std::array of_pose{
    "header.stamp.sec",        "header.stamp.nanosec",    "pose.pose.position.x",
    "pose.pose.position.y",    "pose.pose.position.z",    "pose.pose.orientation.w",
    "pose.pose.orientation.x", "pose.pose.orientation.y", "pose.pose.orientation.z"};
constexpr std::array of_twist{"header.stamp.sec", "header.stamp.nanosec", "twist.twist.linear.x",
                              "twist.twist.linear.y", "twist.twist.linear.z"};
constexpr std::array of_fix{"header.stamp.sec", "header.stamp.nanosec", "latitude", "longitude",
                            "altitude"};
constexpr std::array of_imu{"header.stamp.sec", "header.stamp.nanosec", "orientation.w",
                            "orientation.x",    "orientation.y",        "orientation.z"};

using Values = MessageValues;
using Origin = frame::Position;

constexpr std::array all_types{
    MessageType{"nav_msgs/msg/Odometry", of_pose,
                [](const Values& values, const Origin& origin) {
                  return Reader(values, origin).position().attitude().body_velocity().result();
                }},
    MessageType{"geometry_msgs/msg/PoseWithCovarianceStamped", of_pose,
                [](const Values& values, const Origin& origin) {
                  return Reader(values, origin).position().attitude().result();
                }},
    MessageType{"sensor_msgs/msg/NavSatFix", of_fix,
                [](const Values& values, const Origin& origin) {
                  return Reader(values, origin).fix().result();
                }},
    MessageType{"geometry_msgs/msg/TwistWithCovarianceStamped", of_twist,
                [](const Values& values, const Origin& origin) {
                  return Reader(values, origin).velocity_in_its_frame().result();
                }},
    MessageType{"sensor_msgs/msg/Imu", of_imu, [](const Values& values, const Origin& origin) {
                  return Reader(values, origin).level().result();
                }}};

}  // namespace

std::span<const MessageType> message_types() { return all_types; }

std::string MessageType::short_name() const {
  std::string text(name);
  return text.erase(text.find("/msg"), 4);
}

}  // namespace drydock::score

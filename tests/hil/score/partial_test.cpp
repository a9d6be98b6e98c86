// Estimates that give a part of a state, as most programs do: what they give is scored.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "estimators/frame/geodetic.hpp"
#include "hil/score/align.hpp"
#include "hil/score/errors.hpp"
#include "hil/score/read_estimates.hpp"
#include "tests/hil/score/message_file.hpp"

namespace drydock::score {
namespace partial_test {

using Eigen::Vector3d;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double degree = std::numbers::pi / 180;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const frame::Position origin{60 * degree, 5 * degree, -20};
/// The bow is east, rolled and pitched; the way is 2 m/s east, 20 m deep.
const Vector3d true_angles = Vector3d{5, -3, 90} * degree;

Track truth() {
  Track track;
  for (int t = 0; t <= 20; ++t)
    track.push_back({.at = measurement::stamp_from_ns(t * 1'000'000'000LL),
                     .position_ned = {0, 2. * t, 0},
                     .angles = true_angles,
                     .velocity = {0, 2, 0}});
  return track;
}

Errors errors_against_truth(const Estimates& estimates, Alignment alignment = Alignment::none) {
  auto pairs = pairs_of(estimates.track, truth(), std::chrono::seconds{2});
  EXPECT_EQ(align(pairs.all, alignment), "");
  return errors_of(pairs.all, std::chrono::seconds{1});
}

/// `line`: the cells behind the time, for each second.
Estimates csv(const std::string& head, const std::function<std::string(int)>& line) {
  std::string text = "t_s," + head + "\n";
  for (int t = 0; t <= 20; ++t) text += std::to_string(t) + "," + line(t) + "\n";
  std::istringstream in(text);
  const auto read = read_csv(in, "a.csv", origin);
  EXPECT_TRUE(read) << read.error().line;
  return *read;
}

TEST(APartialCsv, OfPositionsInTwoDimensionsIsScoredInTwo) {
  const auto estimates =
      csv("north_m,east_m", [](int t) { return "3," + std::to_string(2 * t + 4); });
  const auto errors = errors_against_truth(estimates);
  EXPECT_NEAR(errors.ate_m->rms, 5, 1e-12);
  EXPECT_NEAR(errors.ate_m->max, 5, 1e-12);
  EXPECT_NEAR(*errors.horizontal_rms_m, 5, 1e-12);
  EXPECT_FALSE(errors.vertical_rms_m);
  EXPECT_NEAR(errors.rpe_m->max, 0, 1e-12);
  EXPECT_THAT(errors.told, ElementsAre(21, 21, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_NEAR(errors_against_truth(estimates, Alignment::start).ate_m->max, 0, 1e-12);
  EXPECT_NEAR(errors_against_truth(estimates, Alignment::yaw).ate_m->max, 0, 1e-12);
}

TEST(APartialCsv, InDegreesNeedsNoHeight) {
  const auto at = frame::at_ned_offset(origin, {3, 4, 0});
  const auto errors = errors_against_truth(csv("longitude_deg,latitude_deg", [&](int t) {
    const auto place = frame::at_ned_offset(at, {0, 2. * t, 0});
    std::ostringstream text;
    text.precision(12);
    text << place.longitude_rad / degree << ',' << place.latitude_rad / degree;
    return text.str();
  }));
  EXPECT_NEAR(errors.ate_m->rms, 5, 1e-3);
  EXPECT_FALSE(errors.vertical_rms_m);
}

TEST(APartialCsv, OfAHeightAloneIsScoredVertically) {
  const auto errors = errors_against_truth(csv("altitude_m", [](int) { return "-22"; }));
  EXPECT_NEAR(*errors.vertical_rms_m, 2, 1e-12);
  EXPECT_FALSE(errors.horizontal_rms_m);
  EXPECT_THAT(errors.told, ElementsAre(0, 0, 21, 0, 0, 0, 0, 0, 0));
}

TEST(APartialCsv, OfAnAttitudeAloneHasTheErrorsOfItsAngles) {
  const auto errors = errors_against_truth(
      csv("roll_deg,pitch_deg,yaw_deg,roll_sigma_deg,pitch_sigma_deg,heading_sigma_deg",
          [](int) { return "6,-3,92,1,1,1"; }));
  EXPECT_NEAR(errors.roll_deg->rms, 1, 1e-9);
  EXPECT_NEAR(errors.pitch_deg->rms, 0, 1e-9);
  EXPECT_NEAR(errors.heading_deg->rms, 2, 1e-9);
  EXPECT_NEAR(errors.heading_deg->max, 2, 1e-9);
  EXPECT_NEAR(*errors.attitude_nees.mean, 5. / 3, 1e-9);
  EXPECT_NEAR(errors.rpe_deg->rms, 0, 1e-5);
  EXPECT_FALSE(errors.ate_m);
  EXPECT_FALSE(errors.velocity_mps);
}

TEST(APartialCsv, WithoutAHeadingHasRollAndPitch) {
  const auto errors =
      errors_against_truth(csv("roll_deg,pitch_deg", [](int t) { return t < 10 ? "5,-3" : "5,"; }));
  EXPECT_NEAR(errors.roll_deg->max, 0, 1e-9);
  EXPECT_FALSE(errors.attitude_deg) << "the turn needs all three";
  EXPECT_FALSE(errors.heading_deg);
  EXPECT_THAT(errors.told, ElementsAre(0, 0, 0, 21, 10, 0, 0, 0, 0)) << "empty cells tell nothing";
}

TEST(APartialCsv, MayHaveAQuaternion) {
  // A half angle of 46 degrees about down: 2 degrees past east.
  std::ostringstream q;
  q.precision(17);
  q << std::cos(46 * degree) << ",0,0," << std::sin(46 * degree);
  const auto errors = errors_against_truth(csv("qw,qx,qy,qz", [&](int) { return q.str(); }));
  EXPECT_NEAR(errors.heading_deg->rms, 2, 1e-9);
  EXPECT_NEAR(errors.roll_deg->rms, 5, 1e-9);
  EXPECT_NEAR(errors.pitch_deg->rms, 3, 1e-9);
}

TEST(APartialCsv, OfAVelocityAloneIsScored) {
  const auto errors = errors_against_truth(
      csv("velocity_north_mps,velocity_east_mps,velocity_north_sigma_mps,velocity_east_sigma_mps",
          [](int) { return "0.3,2.4,0.1,0.2"; }));
  EXPECT_NEAR(errors.velocity_mps->rms, 0.5, 1e-12);
  EXPECT_NEAR(*errors.velocity_nees.mean, (9 + 4) / 2., 1e-9);
  EXPECT_THAT(errors.told, ElementsAre(0, 0, 0, 0, 0, 0, 21, 21, 0));
  const auto ahead = errors_against_truth(csv("body_forward_mps", [](int) { return "2.5"; }));
  EXPECT_NEAR(ahead.velocity_mps->rms, 2.5 - 2 * std::cos(3 * degree), 1e-12)
      << "pitched, the way is not all ahead";
}

TEST(APartialCsv, WithATimeAloneIsRefusedWithWhatItMayHave) {
  std::istringstream in("t_s,speed\n1,2\n");
  EXPECT_THAT(read_csv(in, "a.csv", origin).error().line,
              HasSubstr("roll_deg, pitch_deg, heading_deg, qw, qx, qy, qz, velocity_north_mps"));
}

/// The message types of ROS 2. A velocity, a place and an attitude are off as above.
class APartialMcap : public message_file::WithFile {
 protected:
  using Make = std::function<void(message_file::Cdr&)>;

  message_file::Topic topic(const std::string& name, const std::string& type,
                            const std::string& text, const std::vector<std::string>& types,
                            const std::string& frame, const Make& make) {
    auto all = types;
    all.insert(all.end(), {"std_msgs/Header", "builtin_interfaces/Time"});
    message_file::Topic topic{name, type, message_file::with_types(text, all), {}};
    for (int t = 0; t <= 20; ++t) {
      message_file::Cdr cdr;
      time_s_ = t;
      cdr.header(t * 1'000'000'000LL, frame);
      make(cdr);
      topic.messages.push_back(cdr.bytes);
    }
    return topic;
  }
  message_file::Topic imu(const std::vector<double>& quaternion,
                          const std::vector<double>& variances) {
    return topic("/ahrs", "sensor_msgs/msg/Imu",
                 "std_msgs/Header header\ngeometry_msgs/Quaternion orientation\n"
                 "float64[9] orientation_covariance\n"
                 "geometry_msgs/Vector3 angular_velocity\n"
                 "float64[9] angular_velocity_covariance\n"
                 "geometry_msgs/Vector3 linear_acceleration\n"
                 "float64[9] linear_acceleration_covariance\n",
                 {"geometry_msgs/Quaternion", "geometry_msgs/Vector3"}, "base_link",
                 [&](message_file::Cdr& cdr) {
                   cdr.put(quaternion).put(message_file::diagonal(variances));
                   cdr.put(std::vector<double>(24));
                 });
  }
  message_file::Topic twist(const std::string& frame, const std::vector<double>& linear) {
    return topic(
        "/twist", "geometry_msgs/msg/TwistWithCovarianceStamped",
        "std_msgs/Header header\nTwistWithCovariance twist\n",
        {"geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist", "geometry_msgs/Vector3"},
        frame, [&](message_file::Cdr& cdr) {
          cdr.put(linear).put(std::vector<double>(3));
          cdr.put(message_file::diagonal({.04, .01, .01, 0, 0, 0}));
        });
  }
  message_file::Topic fix(const std::string& name, double altitude_m) {
    return topic(name, "sensor_msgs/msg/NavSatFix",
                 "std_msgs/Header header\nNavSatStatus status\nfloat64 latitude\n"
                 "float64 longitude\nfloat64 altitude\nfloat64[9] position_covariance\n"
                 "uint8 COVARIANCE_TYPE_UNKNOWN = 0\nuint8 position_covariance_type\n",
                 {"sensor_msgs/NavSatStatus"}, "gps", [=, this](message_file::Cdr& cdr) {
                   const auto at = frame::at_ned_offset(origin, {3, 4 + 2. * time_s_, 0});
                   cdr.put(std::int8_t{0}).put(std::uint16_t{1});
                   cdr.put(at.latitude_rad / degree).put(at.longitude_rad / degree);
                   cdr.put(altitude_m).put(message_file::diagonal({1, 1, 1}));
                   cdr.put(std::uint8_t{2});
                 });
  }
  /// Off by 3 m north, 4 m east.
  message_file::Topic pose(const std::string& name, const std::string& type, bool with_twist,
                           const std::vector<double>& quaternion) {
    std::vector<std::string> types{"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose",
                                   "geometry_msgs/Point", "geometry_msgs/Quaternion"};
    if (with_twist)
      for (const char* more :
           {"geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist", "geometry_msgs/Vector3"})
        types.emplace_back(more);
    return topic(name, type,
                 with_twist ? "std_msgs/Header header\nstring child_frame_id\n"
                              "geometry_msgs/PoseWithCovariance pose\n"
                              "geometry_msgs/TwistWithCovariance twist\n"
                            : "std_msgs/Header header\ngeometry_msgs/PoseWithCovariance pose\n",
                 types, "map", [=, this](message_file::Cdr& cdr) {
                   if (with_twist) cdr.put(std::string("base_link"));
                   cdr.put(std::vector<double>{4 + 2. * time_s_, 3, 0}).put(quaternion);
                   cdr.put(message_file::diagonal({16, 9, 1, 1e-6, 1e-6, 1e-6}));
                   if (with_twist) cdr.put(std::vector<double>(6 + 36));
                 });
  }
  Estimates read(const std::vector<message_file::Topic>& topics, const std::string& name = {}) {
    message_file::write(path_, topics);
    const auto read = read_mcap(path_, name, origin);
    EXPECT_TRUE(read) << read.error().line;
    return *read;
  }

  int time_s_ = 0;
};

/// From roll 5, pitch 3 up in REP-103's axes and 2 degrees past east: a turn about up by -2, then
/// pitch 3, roll 5.
const std::vector<double> bow_past_east = [] {
  const Eigen::Quaterniond q = Eigen::AngleAxisd(-2 * degree, Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(3 * degree, Vector3d::UnitY()) *
                               Eigen::AngleAxisd(5 * degree, Vector3d::UnitX());
  return std::vector<double>{q.x(), q.y(), q.z(), q.w()};
}();

TEST_F(APartialMcap, OfAnImuIsScoredInItsAngles) {
  const double variance = std::pow(2 * degree, 2);
  const auto errors =
      errors_against_truth(read({imu(bow_past_east, {variance, variance, variance})}));
  EXPECT_NEAR(errors.heading_deg->rms, 2, 1e-9);
  EXPECT_NEAR(errors.roll_deg->rms, 0, 1e-9);
  EXPECT_NEAR(*errors.attitude_nees.mean, 1. / 3, 1e-9);
  EXPECT_FALSE(errors.ate_m);
}

TEST_F(APartialMcap, OfAnImuWhoseYawHasNoMeaningIsScoredWithoutIt) {
  const auto errors = errors_against_truth(read({imu(bow_past_east, {1e-4, 1e-4, 1e6})}));
  EXPECT_TRUE(errors.roll_deg && errors.pitch_deg);
  EXPECT_FALSE(errors.heading_deg);
  EXPECT_TRUE(errors.attitude_nees.mean) << "of roll and pitch";
}

TEST_F(APartialMcap, OfAGyroWithoutAnOrientationGivesNothingAndSaysSo) {
  const auto estimates = read({imu({0, 0, 0, 1}, {-1, 0, 0})});
  EXPECT_TRUE(estimates.track.empty());
  EXPECT_THAT(estimates.notes, Contains(HasSubstr("it gives no orientation")));
}

TEST_F(APartialMcap, OfATwistIsScoredInItsFrame) {
  const auto enu = errors_against_truth(read({twist("odom", {2.4, .3, 0})}));
  EXPECT_NEAR(enu.velocity_mps->rms, 0.5, 1e-12);
  EXPECT_NEAR(*enu.velocity_nees.mean, (.16 / .04 + .09 / .01) / 3, 1e-9);
  const auto estimates = read({twist("dvl_link", {2.5, 0, 0})});
  EXPECT_THAT(estimates.notes, Contains(HasSubstr("\"dvl_link\" is taken for the body's")));
  const auto body = errors_against_truth(estimates);
  EXPECT_TRUE(body.velocity_in_body);
  // The length of the difference from the truth, 2 m/s along pitch 3, roll 5 degrees.
  EXPECT_NEAR(body.velocity_mps->rms, std::sqrt(2.5 * 2.5 + 4 - 2 * 2.5 * 2 * std::cos(3 * degree)),
              1e-9);
}

TEST_F(APartialMcap, OfAFixIsScoredWithAndWithoutItsAltitude) {
  const auto whole = errors_against_truth(read({fix("/fix", -20)}));
  EXPECT_NEAR(whole.ate_m->rms, 5, 1e-3);
  EXPECT_NEAR(*whole.position_nees.mean, 25. / 3, 1e-2);
  const auto flat = errors_against_truth(read({fix("/fix", nan)}));
  EXPECT_NEAR(flat.ate_m->rms, 5, 1e-3);
  EXPECT_FALSE(flat.vertical_rms_m);
  EXPECT_NEAR(*flat.position_nees.mean, 25. / 2, 1e-2) << "of two axes";
}

TEST_F(APartialMcap, OfAPoseIsScoredInBoth) {
  const auto errors = errors_against_truth(
      read({pose("/pose", "geometry_msgs/msg/PoseWithCovarianceStamped", false, bow_past_east)}));
  EXPECT_NEAR(errors.ate_m->rms, 5, 1e-12);
  EXPECT_NEAR(*errors.position_nees.mean, 2. / 3, 1e-9);
  EXPECT_NEAR(errors.heading_deg->rms, 2, 1e-9);
}

TEST_F(APartialMcap, OfAnOdometryWithAPositionAloneGivesThat) {
  for (const auto& nothing :
       std::vector<std::vector<double>>{{nan, nan, nan, nan}, {0, 0, 0, 0}, {0, 0, 0, 1}}) {
    const auto estimates = read({pose("/odom", "nav_msgs/msg/Odometry", true, nothing)});
    const auto errors = errors_against_truth(estimates);
    EXPECT_NEAR(errors.ate_m->rms, 5, 1e-12);
    EXPECT_FALSE(errors.attitude_deg);
    EXPECT_FALSE(errors.velocity_mps);
    EXPECT_THAT(estimates.notes, Contains(HasSubstr("no velocity: it is 0")));
  }
}

TEST_F(APartialMcap, OfSeveralTypesTheOneThatTellsMostIsRead) {
  const std::vector<message_file::Topic> all{
      fix("/fix", -20), imu(bow_past_east, {1, 1, 1}),
      pose("/odom", "nav_msgs/msg/Odometry", true, bow_past_east)};
  EXPECT_THAT(read(all).notes, Contains("read is /odom; --topic takes another one: /ahrs, /fix"));
  EXPECT_FALSE(errors_against_truth(read(all, "/ahrs")).ate_m);
}

TEST_F(APartialMcap, OfARunsEstimatorIsJoinedFromItsTopics) {
  const auto errors = errors_against_truth(
      read({pose("/estimate/mine/odometry", "nav_msgs/msg/Odometry", true, {nan, nan, nan, nan}),
            [this] {
              auto own = imu(bow_past_east, {1e-4, 1e-4, 1e6});
              own.name = "/estimate/mine";
              return own;
            }()}));
  EXPECT_NEAR(errors.ate_m->rms, 5, 1e-12);
  EXPECT_TRUE(errors.roll_deg);
}

TEST(AnAlignment, OfEstimatesWithoutAPlaceMovesNothingAndSaysSo) {
  Track angles = truth();
  for (State& state : angles) state.position_ned = untold();
  auto pairs = pairs_of(angles, truth(), std::chrono::seconds{2});
  EXPECT_THAT(align(pairs.all, Alignment::yaw), HasSubstr("moved nothing"));
}

}  // namespace partial_test
}  // namespace drydock::score

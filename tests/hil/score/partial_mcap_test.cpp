// Estimates that give a part of a state, as most programs do: what they give is scored.
#include <gmock/gmock.h>

#include <cmath>

#include "tests/hil/score/message_file.hpp"
#include "tests/hil/score/partial.hpp"

namespace drydock::score::partial_test {

using testing::Contains;
using testing::HasSubstr;

/// The message types of ROS 2. A velocity, a place and an attitude are off as in the CSV files.
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
                           const std::vector<double>& quaternion, double turns = 1e-6) {
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
                   cdr.put(message_file::diagonal({16, 9, 1, turns, turns, turns}));
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

TEST_F(APartialMcap, OfAnOdometryWhoseAttitudeHasNoCovarianceGivesTheAttitude) {
  const auto errors = errors_against_truth(
      read({pose("/odom", "nav_msgs/msg/Odometry", true, bow_past_east, 1e6)}));
  EXPECT_NEAR(errors.heading_deg->rms, 2, 1e-9);
  EXPECT_FALSE(errors.attitude_nees.mean);
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

}  // namespace drydock::score::partial_test

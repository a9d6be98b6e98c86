// Estimators that publish on the bus, as ROS 2 nodes do. The expected numbers follow from REP-103.
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <cmath>
#include <numbers>
#include <regex>

#include "drivers/bus/convert/convert.hpp"
#include "drivers/bus/writer.hpp"
#include "estimators/external/topic_peer.hpp"
#include "estimators/frame/attitude.hpp"
#include "hil/summary/truth_of_rig.hpp"
#include "tests/hil/outside/outside_rig.hpp"
#include "tests/own_domain.hpp"

namespace topic_test {

using namespace drydock;
using outside_rig::estimator;
using outside_rig::Folder;
using outside_rig::one_imu;

constexpr double degree = std::numbers::pi / 180;
const frame::Position origin{60 * degree, 5 * degree, 0};

external::TopicOptions options(bus::OutsideType type, external::Gives gives) {
  return {.estimator = "mine",
          .topic = "/my/estimate",
          .type = type,
          .gives = gives,
          .origin = origin,
          .domain = test::own_domain(),
          .interface = "lo",
          .say = {}};
}

/// What the peer makes of one message, which `set` fills in.
template <class Message, class Set>
std::vector<pipeline::OutsideEstimate> heard(external::TopicPeer& peer, const char* frame,
                                             Set set) {
  const bus::Participant participant(test::own_domain(), "lo");
  bus::Writer<Message> writer(participant, "rt/my/estimate", frame);
  set(writer.message());
  for (int i = 0; i < 5000 && writer.matched() == 0; ++i) ::poll(nullptr, 0, 1);
  const auto now = measurement::Stamp{std::chrono::system_clock::now().time_since_epoch()};
  writer.message().header.stamp = bus::to_time(now);
  writer.write(now);
  std::vector<pipeline::OutsideEstimate> estimates;
  for (int i = 0; i < 5000 && estimates.empty() && peer.account().faults() == 0; ++i) {
    peer.poll(estimates);
    ::poll(nullptr, 0, 1);
  }
  return estimates;
}

void set_diagonal(double (&covariance)[36], const std::array<double, 6>& variances) {
  for (std::size_t i = 0; i < 6; ++i) covariance[7 * i] = variances[i];
}

TEST(OutsideTopic, AMatrixThatIsNoCovarianceMakesNoEstimate) {
  external::TopicPeer peer(options(bus::OutsideType::odometry, external::Gives::navigation));
  const auto estimates = heard<bus::OdometryMessage>(peer, "odom", [](auto& message) {
    message.pose.pose.orientation = {0, 0, 0, 1};
    set_diagonal(message.pose.covariance, {1, 1, 1, 1, 1, 1});
    message.pose.covariance[1] = 0.9;  // and nothing below the diagonal
  });
  EXPECT_TRUE(estimates.empty());
  EXPECT_EQ(peer.account().faults(), 1U);
}

TEST(OutsideTopic, AnOdometryIsTurnedToNorthEastDown) {
  external::TopicPeer peer(options(bus::OutsideType::odometry, external::Gives::navigation));
  const auto estimates = heard<bus::OdometryMessage>(peer, "odom", [](auto& message) {
    message.child_frame_id = dds_string_dup("base_link");
    message.pose.pose.position = {3, 4, 5};        // east, north, up
    message.pose.pose.orientation = {0, 0, 0, 1};  // the bow to the east
    message.twist.twist.linear = {2, 0.5, 0.25};   // ahead, to port, up
    set_diagonal(message.pose.covariance, {1, 4, 9, 0.01, 0.02, 0.03});
    set_diagonal(message.twist.covariance, {0.1, 0.2, 0.3, -1, -1, -1});
  });
  ASSERT_EQ(estimates.size(), 1U);
  const auto& estimate = std::get<pipeline::NavigationEstimate>(estimates[0]);
  const auto offset = frame::ned_offset(origin, estimate.position);
  EXPECT_NEAR(offset.x(), 4, 1e-6);
  EXPECT_NEAR(offset.y(), 3, 1e-6);
  EXPECT_NEAR(offset.z(), -5, 1e-6);
  EXPECT_NEAR(frame::euler(estimate.body_to_ned).yaw, 90 * degree, 1e-9);
  EXPECT_NEAR(estimate.velocity_ned.x(), 0.5, 1e-12) << "port of an eastward bow is north";
  EXPECT_NEAR(estimate.velocity_ned.y(), 2, 1e-12);
  EXPECT_NEAR(estimate.velocity_ned.z(), -0.25, 1e-12);
  EXPECT_NEAR(estimate.covariance(0, 0), 4, 1e-9);
  EXPECT_NEAR(estimate.covariance(1, 1), 1, 1e-9);
  EXPECT_NEAR(estimate.covariance(3, 3), 0.2, 1e-9);
  EXPECT_NEAR(estimate.covariance(6, 6), 0.02, 1e-9);
  EXPECT_EQ(peer.account().faults(), 0U);
}

TEST(OutsideTopic, APoseWithoutCovarianceHasNone) {
  external::TopicPeer peer(options(bus::OutsideType::pose, external::Gives::navigation));
  const auto estimates = heard<bus::PoseMessage>(peer, "map", [](auto& message) {
    message.pose.pose.position = {0, 100, 0};
    message.pose.pose.orientation = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};  // the bow to the north
  });
  ASSERT_EQ(estimates.size(), 1U);
  const auto& estimate = std::get<pipeline::NavigationEstimate>(estimates[0]);
  EXPECT_NEAR(frame::ned_offset(origin, estimate.position).x(), 100, 1e-6);
  EXPECT_NEAR(frame::euler(estimate.body_to_ned).yaw, 0, 1e-9);
  EXPECT_TRUE(std::isnan(estimate.covariance(0, 0)));
  EXPECT_TRUE(std::isnan(estimate.velocity_ned.x()));
}

TEST(OutsideTopic, AnImuGivesAnAttitude) {
  external::TopicPeer peer(options(bus::OutsideType::imu, external::Gives::attitude));
  const auto estimates = heard<bus::ImuMessage>(peer, "base_link", [](auto& message) {
    const double half = 10 * degree / 2;  // 10 degrees about the bow, which points east
    message.orientation = {std::sin(half), 0, 0, std::cos(half)};
    message.orientation_covariance[0] = 1e-4;
    message.orientation_covariance[4] = 4e-4;
    message.orientation_covariance[8] = 1e6;
  });
  ASSERT_EQ(estimates.size(), 1U);
  const auto& estimate = std::get<pipeline::AttitudeEstimate>(estimates[0]);
  EXPECT_NEAR(estimate.roll_rad, 10 * degree, 1e-9) << "starboard down is positive in both";
  EXPECT_NEAR(estimate.pitch_rad, 0, 1e-9);
  EXPECT_NEAR(estimate.covariance(0, 0), 1e-4, 1e-9);
}

TEST(OutsideTopic, AVelocityIsTakenInTheAxesOfTheEarthAlone) {
  external::TopicPeer peer(options(bus::OutsideType::twist, external::Gives::velocity));
  const auto set = [](auto& message) {
    message.twist.twist.linear = {1, 2, 3};
    set_diagonal(message.twist.covariance, {0.1, 0.2, 0.3, 0, 0, 0});
  };
  const auto estimates = heard<bus::TwistMessage>(peer, "my_enu", set);
  ASSERT_EQ(estimates.size(), 1U);
  const auto& estimate = std::get<pipeline::NavigationEstimate>(estimates[0]);
  EXPECT_EQ(estimate.velocity_ned, Eigen::Vector3d(2, 1, -3));
  EXPECT_NEAR(estimate.covariance(3, 3), 0.2, 1e-12);
  EXPECT_TRUE(heard<bus::TwistMessage>(peer, "base_link", set).empty());
  EXPECT_EQ(peer.account().malformed, 1U);
}

TEST(OutsideTopic, AFixGivesAPosition) {
  external::TopicPeer peer(options(bus::OutsideType::fix, external::Gives::navigation));
  const auto estimates = heard<bus::NavSatFixMessage>(peer, "base_link", [](auto& message) {
    message.latitude = 59.5;
    message.longitude = -10.25;
    message.altitude = -42;
    message.position_covariance[0] = 1;
    message.position_covariance[4] = 4;
    message.position_covariance[8] = 9;
    message.position_covariance_type = 2;
  });
  ASSERT_EQ(estimates.size(), 1U);
  const auto& estimate = std::get<pipeline::NavigationEstimate>(estimates[0]);
  EXPECT_NEAR(estimate.position.latitude_rad, 59.5 * degree, 1e-12);
  EXPECT_NEAR(estimate.position.longitude_rad, -10.25 * degree, 1e-12);
  EXPECT_NEAR(estimate.covariance(0, 0), 4, 1e-12);
  EXPECT_NEAR(estimate.covariance(1, 1), 1, 1e-12);
}

TEST(OutsideTopic, ValuesThatAreNotFiniteAreCountedAndNotUsed) {
  external::TopicPeer peer(options(bus::OutsideType::fix, external::Gives::navigation));
  EXPECT_TRUE(heard<bus::NavSatFixMessage>(peer, "base_link", [](auto& message) {
                message.latitude = std::nan("");
              }).empty());
  EXPECT_EQ(peer.account().malformed, 1U);
}

/// Some seconds of a rig in real time.
summary::Summary in_real_time(const std::string& more) {
  const Folder folder;
  std::string text = one_imu + more;
  text.insert(text.find("name = \"outside\"\n"),
              "truth = true\ndds_domain = " + std::to_string(test::own_domain()) + "\n");
  std::ofstream(folder / "rig.toml") << text;
  bench::RunOptions options;
  options.duration_s = 3;
  options.quiet = true;
  testing::internal::CaptureStdout();
  const auto rig = rig_config::load_rig(folder / "rig.toml").value();
  auto summary = bench::run_real_time(rig, options);
  testing::internal::GetCapturedStdout();
  return summary;
}

std::string on_topic(const std::string& topic, const std::string& message,
                     const std::string& gives) {
  return "[[estimator]]\nname = \"mine\"\nkind = \"external\"\nimu = \"imu\"\ngives = \"" + gives +
         "\"\ntopic = \"" + topic + "\"\nmessage = \"" + message + "\"\n";
}

/// Of 150 in 3 s; on a busy machine two programs may need most of that to find each other.
constexpr std::uint64_t enough = 25;

TEST(OutsideTopic, WhoSaysTheTruthOfTheBusHasNoError) {
  const std::regex late("[0-9]+ messages; [0-9] out of time");
  const auto summary = in_real_time(on_topic("/estimate/truth/odometry", "odometry", "navigation"));
  const auto& mine = summary.estimators.at(0);
  ASSERT_GT(mine.estimates, enough);
  ASSERT_TRUE(mine.navigation);
  // The origin of the truth's axes is its own first place, so that is what the positions lack.
  EXPECT_LT(mine.navigation->velocity_rms_mps, 1e-6);
  EXPECT_LT(mine.whole_run->roll_rms_deg, 1e-6);
  EXPECT_LT(mine.navigation->heading_rms_deg, 1e-6);
  // On a busy machine a few messages come too late, and the verdict rightly says so.
  const auto& verdict = summary.verdicts.at(0);
  EXPECT_TRUE(verdict.passed || std::regex_match(verdict.measured, late)) << verdict.measured;
}

TEST(OutsideTopic, TheTruthsFixIsTheTruePlace) {
  const auto summary = in_real_time(on_topic("/estimate/truth/fix", "fix", "navigation"));
  const auto& mine = summary.estimators.at(0);
  ASSERT_GT(mine.estimates, enough);
  EXPECT_LT(mine.navigation->horizontal_max_m, 1e-5);
  EXPECT_LT(mine.navigation->depth_rms_m, 1e-5);
}

TEST(TruthOnTheBus, IsNotToldBesideARealDevice) {
  const Folder folder;
  std::ofstream(folder / "rig.toml") << one_imu;
  auto rig = rig_config::load_rig(folder / "rig.toml").value();
  EXPECT_TRUE(summary::no_real_device(rig));
  rig.devices[0].link = "serial:/dev/ttyUSB0?baud=115200";
  EXPECT_FALSE(summary::no_real_device(rig));
  rig.devices[0].link = "file:/tmp/a.raw";
  EXPECT_FALSE(summary::no_real_device(rig)) << "a recorded device is not of this truth";
}

}  // namespace topic_test

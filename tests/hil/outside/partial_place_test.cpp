// An estimator of another program that gives a place without a height: its odometry has the place.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drivers/recordings/record/layouts.hpp"
#include "drivers/recordings/record/recording.hpp"
#include "hil/replay/reference/references.hpp"
#include "tests/hil/outside/outside_rig.hpp"

namespace partial_place_test {

using namespace outside_rig;
using Positions = std::vector<Eigen::Vector3d>;  ///< east, north, up

Positions odometry_of(const std::string& path) {
  Positions all;
  auto recording = drydock::record::Recording::open(path).value();
  drydock::record::Layouts layouts;
  while (const auto event = recording.next()) {
    const auto* message = std::get_if<drydock::record::Understood>(&*event);
    if (message == nullptr || message->channel->topic != "/estimate/mine/odometry") continue;
    Eigen::Vector3d at = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    for (const auto& [name, value] :
         drydock::replay::values_of(*layouts.of(*message), message->cdr))
      for (int axis = 0; axis < 3; ++axis)
        if (name == std::string("pose.pose.position.") + "xyz"[axis] && value.is_number())
          at[axis] = value.get<double>();
    all.push_back(at);
  }
  return all;
}

/// Of a run in which the estimate goes north by 1e-4 degrees a second.
Positions odometry_with(const std::string& estimate) {
  const Folder folder;
  std::ofstream(folder / "client.py") << client(estimate);
  std::ofstream(folder / "rig.toml") << one_imu + estimator("navigation");
  drydock::bench::RunOptions options;
  options.duration_s = 2;
  options.record.path = folder / "run.mcap";
  testing::internal::CaptureStdout();
  drydock::bench::run_lockstep(drydock::rig_config::load_rig(folder / "rig.toml").value(), options);
  testing::internal::GetCapturedStdout();
  return odometry_of(folder / "run.mcap");
}

/// The radius of curvature of the WGS-84 meridian, times the angle.
double north_m(double latitude_deg, double by_deg) {
  constexpr double a = 6378137, f = 1 / 298.257223563, degree = std::numbers::pi / 180;
  const double e2 = f * (2 - f), s = std::sin(latitude_deg * degree);
  return a * (1 - e2) / std::pow(1 - e2 * s * s, 1.5) * by_deg * degree;
}

TEST(OutsideEstimator, ThatGivesNoHeightHasAnOdometryNorthAndEast) {
  const auto way = odometry_with("{'latitude_deg': 36.0 + 1e-4 * t, 'longitude_deg': 129.0}");
  ASSERT_GT(way.size(), 100u);
  const double seconds = static_cast<double>(way.size() - 1) / 100;
  EXPECT_NEAR(way.back().y(), north_m(36, 1e-4 * seconds), 1e-3);
  EXPECT_NEAR(way.back().x(), 0, 1e-6);
  EXPECT_TRUE(std::isnan(way.back().z()));
}

TEST(OutsideEstimator, ThatLearnsItsHeightLaterCountsFromIt) {
  const auto way = odometry_with(
      "({'latitude_deg': 36.0, 'longitude_deg': 129.0} | ({} if t < 1 else {'height_m': -10 - "
      "t}))");
  ASSERT_GT(way.size(), 150u);
  EXPECT_TRUE(std::isnan(way.front().z()));
  const double seconds = static_cast<double>(way.size() - 1) / 100;
  EXPECT_NEAR(way.back().z(), 1 - seconds, 0.02);
  EXPECT_NEAR(way.back().y(), 0, 1e-6);
}

}  // namespace partial_place_test

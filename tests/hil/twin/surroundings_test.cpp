#include "hil/twin/surroundings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "hil/motion/splined/splined_trajectory.hpp"

namespace drydock::twin {
namespace {

const measurement::Stamp dive_start = measurement::stamp_from_ns(1'000'000'000'000'000'000);
constexpr double mps = 2;

/// A vehicle 10 m deep on a circle, or straight to the north.
motion::SplinedTrajectory way(double turn_radps) {
  motion::Poses poses;
  double north = 0, east = 0;
  for (int k = 0; k <= 600; ++k) {
    poses.push_back({1.0 * k, frame::at_ned_offset({0.6, 2, 0}, {north, east, 10}),
                     frame::body_to_ned({0, 0, frame::wrap_pi(turn_radps * k)})});
    north += mps * std::cos(turn_radps * (k + 0.5));
    east += mps * std::sin(turn_radps * (k + 0.5));
  }
  return {poses, ocean::Ocean({}, {}), dive_start};
}

/// What a log with a bias of 0.1 m/s says in a current of 0.3 m/s north and -0.2 m/s east, and a
/// DVL over a bed that is 40 m deep.
ByDevice measured(double turn_radps) {
  ByDevice all(2);
  for (int k = 1; k < 600; ++k) {
    const double heading = turn_radps * k;
    measurement::WaterSpeed log;
    log.origin.valid_at = dive_start + std::chrono::seconds{k};
    log.longitudinal_mps = mps - 0.3 * std::cos(heading) + 0.2 * std::sin(heading) + 0.1;
    all[0].push_back(log);
    measurement::BottomVelocity dvl;
    dvl.origin.valid_at = log.origin.valid_at;
    dvl.origin.device = 1;
    dvl.altitude_m = 30;
    all[1].push_back(dvl);
  }
  return all;
}

rig_config::Rig rig() {
  rig_config::Rig rig;
  rig.devices.resize(2);
  return rig;
}

TEST(Surroundings, HaveTheCurrentThatTheLogSawOnACircleWhateverItsBias) {
  const auto found = surroundings_of(measured(0.02), rig(), way(0.02));
  ASSERT_TRUE(found.current_ne_mps);
  EXPECT_NEAR(found.current_ne_mps->x(), 0.3, 0.001);
  EXPECT_NEAR(found.current_ne_mps->y(), -0.2, 0.001);
  EXPECT_NEAR(*found.bed_depth_m, 40, 0.1);
}

TEST(Surroundings, HaveNoCurrentOnOneHeading) {
  EXPECT_FALSE(surroundings_of(measured(0), rig(), way(0)).current_ne_mps);
}

TEST(Surroundings, HaveABedAlongTheTrackAlsoWhereNoSoundingIs) {
  auto all = measured(0);
  std::erase_if(all[1], [](const auto& m) {
    const double t = measurement::seconds(measurement::origin_of(m).valid_at - dive_start);
    return t > 100 && t < 500;
  });
  const std::vector<double> times{0, 50, 300, 599};
  for (const double bed : bed_along(all, rig(), way(0), times)) EXPECT_NEAR(bed, 40, 0.1);
  EXPECT_TRUE(bed_along(ByDevice(2), rig(), way(0), times).empty());
}

}  // namespace
}  // namespace drydock::twin

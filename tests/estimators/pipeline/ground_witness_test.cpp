// A DVL that watches an IMU: how soon a fault of the IMU makes the estimates invalid.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "estimators/frame/earth.hpp"
#include "tests/estimators/pipeline/support.hpp"

namespace drydock::pipeline {
namespace {

using test::at_ms;
using test::imu_device;
using test::log_device;

constexpr double deg = 0.0174533;
constexpr std::uint16_t dvl_device = 6;

EstimatorKind watched_leveling(leveling::FilterKind kind, bool watched) {
  LevelingOptions options;
  options.log = log_device;
  if (watched) options.ground = AidingSensor{dvl_device, {0.8, 0, 0.35}};
  options.kind = kind;
  options.filter = leveling::options_for(kind);
  options.filter.latitude_rad = 0.6;
  return options;
}

EstimatorKind watched_mixing() {
  MixingOptions options;
  options.log = log_device;
  options.ground = AidingSensor{dvl_device, Eigen::Vector3d::Zero()};
  options.filter.latitude_rad = 0.6;
  return options;
}

/// A level vehicle at 2 m/s straight ahead to the north, so every tilt is an error. IMU 100 Hz with
/// noise of 1e-5 rad/s and .005 m/s2; log 2 Hz with .05 m/s; DVL 5 Hz with .01 m/s.
class Watched {
 public:
  explicit Watched(EstimatorKind kind) {
    PipelineOptions options = test::moving(std::chrono::milliseconds{200});
    options.estimators[0].kind = std::move(kind);
    pipeline.emplace(*make_pipeline(options, estimates));
  }

  void run(double seconds) {
    for (long i = std::lround(100 * seconds); i > 0; --i, ++tick) sample();
  }
  bool valid() const { return estimates.all.back().integrity.valid; }
  EstimatorStatus status() const { return pipeline->status(0); }
  /// The longest time in which an estimate was valid and more than five sigmas wrong.
  double wrong_while_valid_s() const {
    long in_a_row = 0, longest = 0;
    for (const auto& estimate : estimates.all) {
      const auto beyond = [&](double error, int axis) {
        return std::abs(error) > 5 * std::sqrt(estimate.covariance(axis, axis));
      };
      const bool wrong = beyond(estimate.roll_rad, 0) || beyond(estimate.pitch_rad, 1);
      in_a_row = wrong && estimate.integrity.valid ? in_a_row + 1 : 0;
      longest = std::max(longest, in_a_row);
    }
    return 0.01 * static_cast<double>(longest);
  }

  test::Estimates estimates;
  std::optional<Pipeline> pipeline;
  std::int64_t tick = 0;
  Eigen::Vector3d rate_error = Eigen::Vector3d::Zero();  ///< of the gyros, rad/s
  Eigen::Vector3d rate_drift = Eigen::Vector3d::Zero();  ///< of the gyros, rad/s2
  Eigen::Vector3d dvl_error = Eigen::Vector3d::Zero();
  double dvl_noise = 0.01;
  bool bottom_lock = true;

 private:
  Eigen::Vector3d noise() { return {normal_(random_), normal_(random_), normal_(random_)}; }

  void sample() {
    if (tick % 50 == 0)
      pipeline->receive(test::water_speed(10 * tick, 2 + 0.05 * normal_(random_)));
    auto imu = test::imu(10 * tick);
    rate_error += 0.01 * rate_drift;
    imu.angular_rate = frame::earth_rate_ned(0.6) + 1e-5 * noise() + rate_error;
    imu.specific_force = Eigen::Vector3d{0, 0, -frame::gravity(0.6, 0)} + 0.005 * noise();
    pipeline->receive(imu);
    if (tick % 20 == 0) see_the_bottom();
  }
  void see_the_bottom() {
    measurement::BottomVelocity track;
    track.origin.valid_at = track.origin.received_at = at_ms(10 * tick);
    track.origin.device = dvl_device;
    if (bottom_lock) track.velocity = Eigen::Vector3d{2, 0, 0} + dvl_noise * noise() + dvl_error;
    pipeline->receive(track);
  }

  std::mt19937_64 random_{8};
  std::normal_distribution<double> normal_;
};

/// A drift of a gyro, deg/s per s, and its axis.
struct Drift {
  double deg_per_s2;
  int axis;
};

class EveryDrift : public testing::TestWithParam<Drift> {};

INSTANTIATE_TEST_SUITE_P(Gyros, EveryDrift,
                         testing::Values(Drift{0.005, 0}, Drift{0.025, 0}, Drift{0.05, 0},
                                         Drift{-0.05, 1}, Drift{0.15, 0}, Drift{0.15, 1},
                                         Drift{0.5, 1}));

TEST_P(EveryDrift, OfAGyroMakesTheEstimatesInvalidTwoSecondsAfterTheyAreFiveSigmasWrong) {
  for (const auto kind : {leveling::FilterKind::augmented, leveling::FilterKind::robust}) {
    Watched bench(watched_leveling(kind, true));
    bench.run(120);
    ASSERT_TRUE(bench.valid());
    bench.rate_drift(GetParam().axis) = GetParam().deg_per_s2 * deg;
    bench.run(20);
    bench.rate_drift.setZero();
    bench.run(10);
    EXPECT_LE(bench.wrong_while_valid_s(), 2);
  }
}

TEST(GroundWitness, IsTheOnlyOneThatSeesADriftSoSoon) {
  // .05 deg/s2 turn the level by .05 t2 / 2 degrees: .9 degrees after six seconds.
  for (const bool watched : {false, true}) {
    Watched bench(watched_leveling(leveling::FilterKind::augmented, watched));
    bench.run(120);
    bench.rate_drift.x() = 0.05 * deg;
    bench.run(6.2);
    EXPECT_EQ(bench.valid(), !watched);
  }
}

TEST(GroundWitness, ChangesNoEstimateAndTakesNoValidityOfSoundSensors) {
  for (const auto kind : {leveling::FilterKind::augmented, leveling::FilterKind::robust}) {
    Watched bench(watched_leveling(kind, true)), alone(watched_leveling(kind, false));
    bench.run(600);
    alone.run(600);
    EXPECT_EQ(bench.status().valid_estimates, alone.status().valid_estimates);
    EXPECT_EQ(bench.estimates.all.back().roll_rad, alone.estimates.all.back().roll_rad);
    EXPECT_EQ(bench.estimates.all.back().covariance, alone.estimates.all.back().covariance);
    EXPECT_EQ(bench.estimates.all.back().fed_by, alone.estimates.all.back().fed_by);
  }
}

TEST(GroundWitness, LetsNoFaultOfItsDvlStartTheEstimatorAgain) {
  struct Fault {
    double step_mps, noise_mps;
    bool bottom_lock;
  };
  for (const Fault& fault : {Fault{0.3, 0.01, true}, Fault{0, 0.1, true}, Fault{0, 0.01, false}}) {
    Watched bench(watched_leveling(leveling::FilterKind::augmented, true));
    bench.run(120);
    SCOPED_TRACE(testing::Message() << fault.step_mps << " m/s, noise " << fault.noise_mps
                                    << ", lock " << fault.bottom_lock);
    bench.dvl_error.y() = fault.step_mps;
    bench.dvl_noise = fault.noise_mps;
    bench.bottom_lock = fault.bottom_lock;
    bench.run(30);
    EXPECT_TRUE(bench.valid()) << "a jump of the velocity is none of the level";
    bench.dvl_error.setZero();
    bench.dvl_noise = 0.01;
    bench.bottom_lock = true;
    bench.run(10);
    EXPECT_TRUE(bench.valid());
    EXPECT_EQ(bench.status().divergences, 0u);
  }
}

TEST(GroundWitness, WatchesTheMixingFilterToo) {
  Watched bench(watched_mixing());
  bench.run(120);
  ASSERT_TRUE(bench.valid());
  bench.rate_drift.x() = 0.05 * deg;
  bench.run(6.2);
  EXPECT_FALSE(bench.valid());
  bench.run(14);
  EXPECT_LE(bench.wrong_while_valid_s(), 2);
}

TEST(GroundWitness, RefusesAVelocityThatIsNoNumberOrThatNoVehicleHas) {
  Watched bench(watched_leveling(leveling::FilterKind::augmented, true));
  bench.run(60);
  for (const double bad : {std::nan(""), HUGE_VAL, 1000.}) {
    bench.dvl_error.z() = bad;
    bench.run(5);
  }
  bench.pipeline->flush();
  EXPECT_EQ(bench.pipeline->counters()[dvl_device].refused, 75u);
  EXPECT_TRUE(bench.valid());
}

TEST(Pipeline, WhoseImuAFindingNamesGivesNoValidEstimatesUntilFiveSecondsAfterIt) {
  Watched bench(watched_leveling(leveling::FilterKind::augmented, false));
  bench.run(120);
  bench.pipeline->doubt(log_device, true);
  bench.run(1);
  EXPECT_TRUE(bench.valid()) << "another device is none of its IMU";
  bench.pipeline->doubt(imu_device, true);
  bench.run(10);
  EXPECT_FALSE(bench.valid());
  bench.pipeline->doubt(imu_device, false);
  bench.run(4.5);
  EXPECT_FALSE(bench.valid());
  bench.run(1);
  EXPECT_TRUE(bench.valid());
}

}  // namespace
}  // namespace drydock::pipeline

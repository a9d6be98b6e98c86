#include "estimators/mixing/mixing_filter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"

namespace drydock::mixing::mixing_filter_test {
namespace {

using Eigen::Vector3d;
using frame::Euler;

constexpr double degree = std::numbers::pi / 180, dt = 0.01, latitude = 36 * degree;
constexpr std::array all_types{MixingType::fixed_gain, MixingType::fuzzy_inference,
                               MixingType::gain_schedule, MixingType::compensated};

MixingOptions options_of(MixingType type) {
  MixingOptions options;
  options.type = type;
  options.latitude_rad = latitude;
  return options;
}

struct Reading {
  Vector3d force, rate;
};

/// Perfect sensors of a vehicle on a straight and steady course.
Reading steady(const Euler& attitude) {
  const Eigen::Matrix3d to_body = frame::ned_to_body(attitude);
  return {to_body * Vector3d{0, 0, -frame::gravity(latitude)},
          to_body * frame::earth_rate_ned(latitude)};
}

TEST(MixingFilter, StartsFromTheAccelerometers) {
  const Euler truth{10 * degree, -5 * degree, 0};
  for (const MixingType type : all_types) {
    MixingFilter filter(options_of(type));
    filter.start(steady(truth).force, steady(truth).rate, 3);
    EXPECT_NEAR(filter.roll(), truth.roll, 1e-4);  // 3 m/s times the Earth's rate over g
    EXPECT_NEAR(filter.pitch(), truth.pitch, 1e-12);
  }
}

TEST(MixingFilter, AStartInAnAccelerationDecaysAndTheEarthTurnsNothing) {
  const Euler truth{20 * degree, 15 * degree, 2};
  for (const MixingType type : all_types) {
    auto options = options_of(type);
    options.heading_rad = truth.yaw;
    MixingFilter filter(options);
    const auto [force, rate] = steady(truth);
    filter.start(force + Vector3d{2, 1, 0}, rate, 0);
    for (int i = 0; i < 720'000; ++i) filter.step(force, rate, 0, dt);
    EXPECT_NEAR(filter.roll(), truth.roll, 1e-3 * degree);
    EXPECT_NEAR(filter.pitch(), truth.pitch, 1e-3 * degree);
    EXPECT_NEAR(frame::wrap_pi(filter.heading() - truth.yaw), 0, 5 * degree);
  }
}

TEST(MixingFilter, AWrongGivenStartLooksLikeAManoeuvreToAllButTypeOne) {
  const auto [force, rate] = steady({});
  for (const MixingType type : all_types) {
    auto options = options_of(type);
    options.accelerometer_start = false;
    options.initial_roll_rad = 20 * degree;
    MixingFilter filter(options);
    filter.start(force, rate, 0);
    for (int i = 0; i < 100; ++i) filter.step(force, rate, 0, dt);
    if (type == MixingType::fixed_gain) {
      EXPECT_EQ(filter.gains().k1, 0.008);
    } else {
      EXPECT_GE(filter.level(), 8);  // 3.4 m/s2
    }
  }
}

TEST(MixingFilter, AnAccelerometerBiasIsATiltAndAGyroBiasFades) {
  auto [force, rate] = steady({});
  force += Vector3d{0.02, 0.03, 0};
  rate += Vector3d{1e-5, -2e-5, 0};
  MixingFilter filter(options_of(MixingType::fixed_gain));
  filter.start(force, rate, 0);
  for (int i = 0; i < 720'000; ++i) filter.step(force, rate, 0, dt);
  const double g = frame::gravity(latitude);
  EXPECT_NEAR(filter.pitch(), 0.02 / g, 2e-6);
  EXPECT_NEAR(filter.roll(), -0.03 / g, 2e-6);
}

// s2 + K1 s + K1 K2 from Table 4 has two real poles, 0.00155 and 0.00645 1/s. With K2 alone it has
// a natural frequency of 0.0354 rad/s.
TEST(MixingFilter, TypeOneIsTheSecondOrderLoopOfItsGains) {
  const auto [force, rate] = steady({});
  for (const auto reading : {IntegralGain::k1_k2, IntegralGain::k2_alone}) {
    auto options = options_of(MixingType::fixed_gain);
    options.integral_gain = reading;
    options.accelerometer_start = false;
    options.initial_pitch_rad = 1e-3;
    MixingFilter filter(options);
    filter.start(force, rate, 0);
    for (int i = 0; i < 20'000; ++i) filter.step(force, rate, 0, dt);
    const double t = 200, k1 = 0.008, ki = reading == IntegralGain::k1_k2 ? 1e-5 : 0.00125;
    const double half = k1 / 2, root = std::sqrt(std::abs(half * half - ki));
    const double expected =
        reading == IntegralGain::k1_k2
            ? std::exp(-half * t) * (std::cosh(root * t) - half / root * std::sinh(root * t))
            : std::exp(-half * t) * (std::cos(root * t) - half / root * std::sin(root * t));
    EXPECT_NEAR(filter.pitch() / 1e-3, expected, 2e-3);
  }
}

TEST(MixingFilter, ASteadyTurnWithoutSlipIsNoTilt) {
  const double u = 6, turn = 0.02;
  for (const MixingType type : all_types) {
    auto options = options_of(type);
    options.pivot_m = 0;
    MixingFilter filter(options);
    for (int i = 0; i < 6000; ++i) {
      auto [force, rate] = steady({0, 0, turn * dt * i});
      force.y() += u * turn;
      rate.z() += turn;
      if (i == 0) filter.start(force, rate, u);
      filter.step(force, rate, u, dt);
    }
    EXPECT_NEAR(filter.roll(), 0, 0.01 * degree);
    EXPECT_NEAR(filter.pitch(), 0, 0.01 * degree);
  }
}

/// The pitch after 1 m/s2 ahead for 20 s.
double pitch_after_acceleration(MixingType type, int* highest_level = nullptr) {
  auto [force, rate] = steady({});
  auto options = options_of(type);
  options.accelerometer_start = false;
  MixingFilter filter(options);
  filter.start(force, rate, 5);
  double u = 5;
  for (int i = 0; i < 500; ++i) filter.step(force, rate, u, dt);
  force.x() += 1;
  for (int i = 0; i < 2000; ++i) {
    u += dt;
    filter.step(force, rate, u - dt / 2, dt);
    if (highest_level) *highest_level = std::max(*highest_level, filter.level());
  }
  return filter.pitch();
}

TEST(MixingFilter, AnAccelerationTiltsTypeOneMostAndTheCompensatedNotAtAll) {
  // K1 dv / g, 0.93 deg, plus the part of the integral; at level 5 an eighth of it.
  EXPECT_NEAR(pitch_after_acceleration(MixingType::fixed_gain), 0.93 * degree, 0.1 * degree);
  int level = 0;
  EXPECT_LT(pitch_after_acceleration(MixingType::fuzzy_inference, &level), 0.15 * degree);
  EXPECT_EQ(level, 5);
  EXPECT_LT(pitch_after_acceleration(MixingType::gain_schedule), 0.15 * degree);
  level = 0;
  EXPECT_NEAR(pitch_after_acceleration(MixingType::compensated, &level), 0, 0.002 * degree);
  EXPECT_EQ(level, 1);
}

TEST(MixingFilter, TheCompensatedOneKnowsTheSideSlipOfATurn) {
  const double u = 6, turn = 0.12, pivot = 2.5, v = -pivot * turn;
  for (const bool knows : {true, false}) {
    auto options = options_of(MixingType::compensated);
    options.pivot_m = knows ? pivot : 0;
    MixingFilter filter(options);
    for (int i = 0; i < 6000; ++i) {
      auto [force, rate] = steady({0, 0, turn * dt * i});
      force += Vector3d{-turn * v, turn * u, 0};
      rate.z() += turn;
      if (i == 0) filter.start(force, rate, u);
      filter.step(force, rate, u, dt);
    }
    if (knows) {
      EXPECT_NEAR(filter.pitch(), 0, 0.01 * degree);
    } else {
      EXPECT_GT(filter.pitch(), 0.05 * degree);
    }
  }
}

TEST(MixingFilter, StaysFiniteNoseUpAndOnItsBack) {
  for (const MixingType type : all_types) {
    MixingFilter filter(options_of(type));
    filter.start({20, 20, 0}, {0, 0, 0}, 5);
    for (int i = 0; i < 2000; ++i) filter.step({20, 20, 5}, {3, 2, -4}, 5, dt);
    EXPECT_LE(std::abs(filter.roll()), std::numbers::pi);
    EXPECT_LT(std::abs(filter.pitch()), std::numbers::pi / 2);
    EXPECT_LE(std::abs(filter.heading()), std::numbers::pi);
  }
}

}  // namespace
}  // namespace drydock::mixing::mixing_filter_test

#include "estimators/navigation/error_model.hpp"

#include <gtest/gtest.h>

#include <random>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"

namespace drydock::navigation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector15 = Eigen::Matrix<double, 15, 1>;

/// A second implementation of eq. (13) with the height loop, from the functions of earth.hpp.
/// `attitude` is d/dt of C_B^N as a rotation in navigation axes.
struct Rates {
  Vector3d position, velocity, attitude;
};

Rates mechanization(const NavigationState& s, const Vector3d& rate, const Vector3d& force,
                    const HeightLoop& loop, double reference_height) {
  const auto& [latitude, longitude, h] = s.position;
  const Vector3d earth_rate = frame::earth_rate_ned(latitude);
  const Vector3d transport = frame::transport_rate_ned(latitude, h, s.velocity_ned);
  const Matrix3d c = s.body_to_ned.toRotationMatrix();
  Vector3d acceleration = c * force - (2 * earth_rate + transport).cross(s.velocity_ned);
  acceleration.z() += frame::gravity(latitude, h) + loop.k2 * (h - reference_height);
  return {{s.velocity_ned.x() / (frame::meridian_radius(latitude) + h),
           s.velocity_ned.y() / ((frame::transverse_radius(latitude) + h) * std::cos(latitude)),
           -s.velocity_ned.z() - loop.k1 * (h - reference_height)},
          acceleration,
          c * rate - earth_rate - transport};
}

/// The same with errors x: IN is truth plus x, C_IN = (I - phi x) C, biases add to the measured
/// values.
struct Erroneous {
  NavigationState truth;
  Vector3d rate, force;
  HeightLoop loop;

  Rates at(const Vector15& x) const {
    NavigationState in = truth;
    in.position.latitude_rad += x(0);
    in.position.longitude_rad += x(1);
    in.position.height_m += x(2);
    in.velocity_ned += x.segment<3>(3);
    const Vector3d p = x.segment<3>(6);
    in.body_to_ned = Eigen::Quaterniond{Eigen::AngleAxisd{
                         -p.norm(), p.norm() > 0 ? Vector3d{p.normalized()} : Vector3d::UnitX()}} *
                     truth.body_to_ned;
    return mechanization(in, rate + x.segment<3>(9), force + x.segment<3>(12), loop, 0);
  }
};

Erroneous random_case(std::mt19937_64& random) {
  std::uniform_real_distribution<double> one(-1, 1);
  const auto vector = [&](double size) {
    return Vector3d{size * one(random), size * one(random), size * one(random)};
  };
  return {{{1.2 * one(random), 3 * one(random), 3000 * one(random)},
           vector(30),
           frame::body_to_ned({3 * one(random), 1.4 * one(random), 3 * one(random)})},
          vector(0.3),
          vector(12),
          {0.1, 3e-3, 0}};
}

/// The scale for comparisons: an error of this size in each state.
Vector15 scale() {
  Vector15 s;
  s << 1e-6, 1e-6, 6, 1, 1, 1, 1e-2, 1e-2, 1e-2, 1e-3, 1e-3, 1e-3, 0.1, 0.1, 0.1;
  return s;
}

TEST(ErrorModel, AgreesWithTheNumericallyDifferentiatedMechanization) {
  std::mt19937_64 random(1);
  double worst = 0;
  for (int i = 0; i < 50; ++i) {
    const Erroneous model = random_case(random);
    const ErrorDynamics f =
        error_dynamics(model.truth, model.truth.body_to_ned * model.force, model.loop);
    const Rates at_rest = model.at(Vector15::Zero());
    const Vector3d turn_of_frame = at_rest.attitude;
    for (int j = 0; j < 15; ++j) {
      // Central differences of two widths, combined so that the error of second order cancels.
      const auto slope = [&](double width) {
        const Vector15 x = Vector15::Unit(j) * width * scale()(j);
        const Rates up = model.at(x), down = model.at(-x);
        Eigen::Matrix<double, 9, 1> rise;
        rise << up.position - down.position, up.velocity - down.velocity,
            // C_IN = (I - phi x) C: phi' = omega x phi - d(omega), with omega the turn of C in n.
            -(up.attitude - down.attitude);
        return Eigen::Matrix<double, 9, 1>{rise / (2 * width)};
      };
      Eigen::Matrix<double, 9, 1> numeric = (4 * slope(0.05) - slope(0.1)) / 3;
      Vector3d turned = Vector3d::Zero();
      if (j >= 6 && j < 9) turned = turn_of_frame.cross(Vector3d::Unit(j - 6)) * scale()(j);
      numeric.tail<3>() += turned;
      const Eigen::Matrix<double, 9, 1> analytic = f.col(j) * scale()(j);
      for (int row = 0; row < 9; ++row)
        worst = std::max(worst, std::abs(numeric(row) - analytic(row)) / scale()(row));
    }
  }
  RecordProperty("worst_per_second", std::to_string(worst));
  EXPECT_LT(worst, 1e-9);
}

TEST(ErrorModel, IsZeroOutsideItsPattern) {
  std::mt19937_64 random(2);
  const Erroneous model = random_case(random);
  ErrorDynamics f = error_dynamics(model.truth, model.truth.body_to_ned * model.force, model.loop);
  for (std::size_t row = 0; row < 9; ++row)
    for (int i = 0; i < error_dynamics_pattern[row].entries; ++i)
      f(static_cast<int>(row), error_dynamics_pattern[row].columns[static_cast<std::size_t>(i)]) =
          0;
  EXPECT_EQ(f, ErrorDynamics::Zero());
}

TEST(ErrorModel, OneStepOfTheSdinsMovesAnErrorAsFSays) {
  std::mt19937_64 random(3);
  const Erroneous model = random_case(random);
  const double dt = 1e-3;
  const auto after = [&](const Vector3d& velocity_error, const Vector3d& tilt) {
    NavigationState start = model.truth;
    start.velocity_ned += velocity_error;
    start.body_to_ned = quaternion_of(-tilt) * start.body_to_ned;
    Sdins sdins(start);
    IncrementSum sum;
    sum.add(model.rate * dt, model.force * dt, dt);
    sdins.step(sum.take());
    return sdins.state();
  };
  const Vector3d tilt{1e-4, -2e-4, 3e-4};
  const Vector3d gained = (after(Vector3d::Zero(), tilt).velocity_ned -
                           after(Vector3d::Zero(), Vector3d::Zero()).velocity_ned) /
                          dt;
  const Vector3d expected = frame::skew(model.truth.body_to_ned * model.force) * tilt;
  EXPECT_LT((gained - expected).norm(), 1e-3 * expected.norm());
}

}  // namespace
}  // namespace drydock::navigation

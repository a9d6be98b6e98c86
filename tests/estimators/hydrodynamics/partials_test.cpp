#include <gtest/gtest.h>

#include <functional>

#include "estimators/frame/attitude.hpp"
#include "estimators/hydrodynamics/hull_forces.hpp"
#include "tests/estimators/hydrodynamics/support.hpp"

/// Compares eq. (7) and the appendix with differences of eq. (4).
namespace drydock::hydrodynamics::test {
namespace {

using Eigen::Vector3d;
using Acceleration =
    std::function<Velocity(const Eigen::Vector3d& small_rotation, const Velocity& change)>;

struct Situation {
  Velocity velocity;
  frame::Euler attitude;
  Control control;
  Vector3d earth_rate;
};

/// Speeds and rates of both signs, at least `distance` away from zero, where some forces have
/// kinks.
Situation random_situation(std::mt19937_64& random, double distance) {
  std::uniform_real_distribution<double> any(-1, 1);
  const auto off_zero = [&](double size) {
    const double x = any(random);
    return std::copysign(distance, x) + size * x;
  };
  Situation s;
  s.velocity << 2 + any(random), off_zero(0.5), off_zero(0.5), off_zero(0.3), off_zero(0.3),
      off_zero(0.3);
  s.attitude = {any(random), 1.4 * any(random), 3 * any(random)};
  s.control = {0.3 * any(random), 0.3 * any(random), 0.3 * any(random), 2 + any(random)};
  s.earth_rate = 7.292115e-5 * Vector3d{any(random), any(random), any(random)};
  return s;
}

/// Five-point central difference of f at 0 along a unit step: error h^4 f^(5) / 30.
Velocity difference(const std::function<Velocity(double)>& f, double h) {
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

Matrix6 numeric_by_velocity(const Model& model, const Situation& s, double h) {
  Matrix6 numeric;
  const auto attitude = frame::ned_to_body(s.attitude);
  for (int i = 0; i < 6; ++i)
    numeric.col(i) = difference(
        [&](double x) {
          return model.acceleration(s.velocity + x * Velocity::Unit(i), attitude, s.control,
                                    s.earth_rate);
        },
        h);
  return numeric;
}

/// Largest error relative to the largest element.
template <class Matrix>
double error(const Matrix& analytic, const Matrix& numeric) {
  return (analytic - numeric).cwiseAbs().maxCoeff() / analytic.cwiseAbs().maxCoeff();
}

TEST(Partials, AreTheDerivativesOfTheAccelerationsWithEveryCoefficientAtWork) {
  std::mt19937_64 random{1};
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const Model model{vehicle_of_all_coefficients(random)};
    const Situation s = random_situation(random, 0.05);
    const Partials partials =
        model.partials(s.velocity, frame::ned_to_body(s.attitude), s.control, s.earth_rate);
    worst = std::max(worst, error(partials.by_velocity, numeric_by_velocity(model, s, 1e-4)));
  }
  EXPECT_LT(worst, 1e-8);
  RecordProperty("worst_relative_error", std::to_string(worst * 1e12) + "e-12");
}

TEST(Partials, EachCoefficientAloneHasItsPartials) {
  std::mt19937_64 random{2};
  for (const NamedCoefficient& entry : coefficient_table()) {
    Vehicle vehicle = nps_auv().vehicle();
    vehicle.coefficients = {};
    vehicle.coefficients.*entry.member = entry.name.ends_with("dot") ? -100 : 1000;
    const Model model{vehicle};
    const Situation s = random_situation(random, 0.05);
    const Partials partials =
        model.partials(s.velocity, frame::ned_to_body(s.attitude), s.control, s.earth_rate);
    EXPECT_LT(error(partials.by_velocity, numeric_by_velocity(model, s, 1e-4)), 1e-8)
        << entry.axis << " " << entry.name;
  }
}

TEST(Partials, ByAttitudeBecomeThoseByEulerAnglesThroughTheBodyRates) {
  std::mt19937_64 random{3};
  for (int i = 0; i < 200; ++i) {
    const Model model{vehicle_of_all_coefficients(random)};
    Situation s = random_situation(random, 0.05);
    s.earth_rate *= 1000;  // the true rate is too small beside the weight
    Eigen::Matrix<double, 6, 3> numeric, analytic;
    const Partials partials =
        model.partials(s.velocity, frame::ned_to_body(s.attitude), s.control, s.earth_rate);
    for (int angle = 0; angle < 3; ++angle) {
      const Vector3d unit = Vector3d::Unit(angle);
      const auto at = [&](double x) {
        const frame::Euler turned{s.attitude.roll + x * unit[0], s.attitude.pitch + x * unit[1],
                                  s.attitude.yaw + x * unit[2]};
        return model.acceleration(s.velocity, frame::ned_to_body(turned), s.control, s.earth_rate);
      };
      numeric.col(angle) = difference(at, 1e-3);
      analytic.col(angle) = partials.by_attitude * frame::body_rate(s.attitude, unit);
    }
    EXPECT_LT(error(analytic, numeric), 1e-8);
  }
}

TEST(Partials, AreFiniteWithoutCrossFlow) {
  std::mt19937_64 random{4};
  const Model model{vehicle_of_all_coefficients(random)};
  Velocity ahead = Velocity::Zero();
  for (const double u : {0.0, 2.0}) {
    ahead[0] = u;
    const Partials partials = model.partials(ahead, Eigen::Matrix3d::Identity(), {});
    EXPECT_TRUE(partials.by_velocity.allFinite());
    EXPECT_TRUE(model.acceleration(ahead, Eigen::Matrix3d::Identity(), {}).allFinite());
  }
}

TEST(Partials, HoldWhereTheGuardRules) {
  Coefficients c;
  c.Y_v_abs_v = c.Z_w_abs_w = c.K_v_abs_v = c.M_w_abs_w = c.N_v_abs_v = -1000;
  Velocity drift = Velocity::Zero();
  drift.segment<2>(1) << 5e-9, -8e-9;  // as large as the guard; the step is a hundredth of it
  Matrix6 numeric;
  for (int i = 0; i < 6; ++i)
    numeric.col(i) = difference(
        [&](double x) { return hull_forces(c, drift + x * Velocity::Unit(i), {}); }, 1e-10);
  EXPECT_LT(error(hull_force_partials(c, drift, {}), numeric), 1e-7);
  EXPECT_NEAR(cross_flow_speed(3, -4), 5, 1e-12);
}

}  // namespace
}  // namespace drydock::hydrodynamics::test

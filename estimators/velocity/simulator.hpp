#pragma once

#include "estimators/hydrodynamics/model.hpp"

/// The vehicle simulator inside an estimator: the equations of motion without attitude and
/// position. The inertial navigation gives these more accurately. docs/estimators/velocity.md.
namespace drydock::velocity {

/// xi of eq. (5): height (m, up), velocity through the water (m/s) and rate against the Earth
/// (rad/s), body axes.
struct Simulated {
  double height_m = 0;
  hydrodynamics::Velocity velocity = hydrodynamics::Velocity::Zero();
};

/// Further inputs of the equations: C_n^b, and the rotation of the Earth in NED, rad/s.
struct Setting {
  Eigen::Matrix3d ned_to_body = Eigen::Matrix3d::Identity();
  Eigen::Vector3d earth_rate_ned = Eigen::Vector3d::Zero();
};

/// Eq. (1), (4) by Euler's method, for steps of about 10 ms. Without feedback it is the virtual
/// sensor of the earlier method (Koifman and Bar-Itzhack 1999).
class Simulator {
 public:
  Simulator(const hydrodynamics::Model& model, const Simulated& start)
      : model_(model), state_(start) {}

  void step(const Setting& setting, const hydrodynamics::Control& control, double dt) {
    const hydrodynamics::Velocity rate =
        model_.acceleration(state_.velocity, setting.ned_to_body, control, setting.earth_rate_ned);
    state_.height_m -= dt * setting.ned_to_body.col(2).dot(state_.velocity.head<3>());
    state_.velocity += dt * rate;
  }

  const hydrodynamics::Model& model() const { return model_; }
  const Simulated& state() const { return state_; }
  Simulated& state() { return state_; }

 private:
  hydrodynamics::Model model_;
  Simulated state_;
};

}  // namespace drydock::velocity

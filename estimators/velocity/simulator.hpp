#pragma once

#include "estimators/hydrodynamics/model.hpp"

/// The vehicle simulator inside an estimator: the equations of motion without attitude and
/// position. The inertial navigation gives these more accurately. docs/estimators/velocity.md.
namespace drydock::velocity {

/// xi of eq. (5): height (m, up), velocity through the water (m/s) and rate against the Earth
/// (rad/s), body axes.
template <class Real>
struct BasicSimulated {
  Real height_m = 0;
  hydrodynamics::BasicVelocity<Real> velocity = hydrodynamics::BasicVelocity<Real>::Zero();
};
using Simulated = BasicSimulated<double>;

/// Further inputs of the equations: C_n^b, and the rotation of the Earth in NED, rad/s.
template <class Real>
struct BasicSetting {
  Eigen::Matrix3<Real> ned_to_body = Eigen::Matrix3<Real>::Identity();
  Eigen::Vector3<Real> earth_rate_ned = Eigen::Vector3<Real>::Zero();
};
using Setting = BasicSetting<double>;

/// Eq. (1), (4) by Euler's method, for steps of about 10 ms. Without feedback it is the virtual
/// sensor of the earlier method (Koifman and Bar-Itzhack 1999).
template <class Real>
class BasicSimulator {
 public:
  BasicSimulator(const hydrodynamics::BasicModel<Real>& model, const BasicSimulated<Real>& start)
      : model_(model), state_(start) {}

  void step(const BasicSetting<Real>& setting, const hydrodynamics::Control& control, double dt) {
    const hydrodynamics::BasicVelocity<Real> rate =
        model_.acceleration(state_.velocity, setting.ned_to_body, control, setting.earth_rate_ned);
    state_.height_m -= dt * setting.ned_to_body.col(2).dot(state_.velocity.template head<3>());
    state_.velocity += dt * rate;
  }

  const hydrodynamics::BasicModel<Real>& model() const { return model_; }
  const BasicSimulated<Real>& state() const { return state_; }
  BasicSimulated<Real>& state() { return state_; }

 private:
  hydrodynamics::BasicModel<Real> model_;
  BasicSimulated<Real> state_;
};
using Simulator = BasicSimulator<double>;

}  // namespace drydock::velocity

#pragma once

#include <memory>

#include "estimators/pipeline/inertial/inertial_options.hpp"
#include "estimators/pipeline/inertial/innovation_watch.hpp"
#include "estimators/pipeline/inertial/navigation_estimate.hpp"

namespace drydock::pipeline {

/// The innovations of a value, one row for each axis. Empty: the filter did not compare the value.
using navigation::Innovations;

/// An inertial navigation with its aiding sensors. The order of the calls is that of the velocity
/// study: samples, heights and actuator states, then a step, then the other sensors. Values must be
/// finite and refer to the origin of the vehicle.
class AidedInertial {
 public:
  virtual ~AidedInertial() = default;

  virtual void control(const hydrodynamics::Control&) {}
  /// Integrals of angular rate (rad) and specific force (m/s) over `dt`.
  virtual void add_imu(const Eigen::Vector3d& angle, const Eigen::Vector3d& velocity,
                       double dt) = 0;
  virtual Innovations add_height(double height_m) = 0;  ///< at the last sample; up, m
  virtual void step() = 0;                              ///< over the samples since the last step
  /// After the other sensors of a step. Innovations: of a model's velocity, now and then.
  virtual Innovations settle() { return {}; }
  /// True while the sensors contradict the model that aids the navigation. It then does not aid.
  virtual void doubt_model(bool) {}
  /// The model begins anew at the state of the navigation.
  virtual void restart_model() {}
  /// True if the navigation has diverged, as far as the innovations tell.
  virtual bool diverged(const InnovationWatch& watch) const { return watch.contradictions() > 1; }

  virtual Innovations update_ground(const Eigen::Vector3d& velocity_body) = 0;  ///< m/s
  virtual Innovations update_log(double /*longitudinal_mps*/) { return {}; }
  /// The position of a point at `lever` from the origin, body axes; sigma north, east, up, m.
  virtual Innovations update_position(const frame::Position&, const Eigen::Vector3d& /*sigma*/,
                                      const Eigen::Vector3d& /*lever*/) {
    return {};
  }
  virtual Innovations update_heading(double /*true_heading_rad*/) { return {}; }
  /// Adds these standard deviations to velocity (m/s) and attitude (rad) after a gap in the
  /// samples.
  virtual void loosen(double velocity_sigma, double angle_sigma) = 0;
  /// The same for the biases of gyros (rad/s) and accelerometers (m/s2), each axis.
  virtual void loosen_biases(double rate_sigma, double force_sigma) = 0;
  virtual void loosen_position(double sigma) = 0;  ///< the same, horizontal, m

  virtual const navigation::NavigationState& state() const = 0;  ///< at the last step
  virtual const Eigen::Vector3d& gyro_bias() const = 0;          ///< present estimate, rad/s
  virtual std::uint64_t rejected() const = 0;                    ///< values outside the gate
  virtual navigation::InnovationTally taken() const = 0;         ///< innovations inside the gate
  virtual void fill(NavigationEstimate& estimate) const = 0;     ///< state, covariance, current
};

/// Fills state and covariance. `errors` is the covariance of the first nine errors of a filter (rad
/// rad m, m/s, rad): eq. (14) of docs/estimators/navigation.md.
void fill_navigation(const navigation::NavigationState& state,
                     const Eigen::Matrix<double, 9, 9>& errors, NavigationEstimate& estimate);

/// Throws std::invalid_argument (one line) for a vehicle with an invalid mass matrix.
std::unique_ptr<AidedInertial> make_aided_inertial(const InertialOptions& options);

}  // namespace drydock::pipeline

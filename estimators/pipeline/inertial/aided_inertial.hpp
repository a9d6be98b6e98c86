#pragma once

#include <memory>

#include "estimators/pipeline/inertial/inertial_options.hpp"
#include "estimators/pipeline/inertial/navigation_estimate.hpp"

namespace drydock::pipeline {

/// What a value told the filter, a row an axis; empty: it was not compared.
using navigation::Innovations;

/// An inertial navigation with what aids it, in the order in which the velocity study feeds it:
/// samples, heights and the actuators' word, then a step, then the other sensors. Values are those
/// of the vehicle's origin and finite.
class AidedInertial {
 public:
  virtual ~AidedInertial() = default;

  virtual void control(const hydrodynamics::Control&) {}
  /// Integrals of angular rate (rad) and specific force (m/s) over `dt`.
  virtual void add_imu(const Eigen::Vector3d& angle, const Eigen::Vector3d& velocity,
                       double dt) = 0;
  virtual Innovations add_height(double height_m) = 0;  ///< at the last sample; up, m
  virtual void step() = 0;                              ///< over the samples since the last one
  virtual void settle() {}                              ///< after the other sensors of a step

  virtual Innovations update_ground(const Eigen::Vector3d& velocity_body) = 0;  ///< m/s
  virtual Innovations update_log(double /*longitudinal_mps*/) { return {}; }
  /// At `lever` from the origin, body axes; sigma north, east, up, m.
  virtual Innovations update_position(const frame::Position&, const Eigen::Vector3d& /*sigma*/,
                                      const Eigen::Vector3d& /*lever*/) {
    return {};
  }
  /// After a gap in the samples: velocity (m/s) and attitude (rad) have become less certain.
  virtual void loosen(double velocity_sigma, double angle_sigma) = 0;

  virtual const navigation::NavigationState& state() const = 0;  ///< at the last step
  virtual const Eigen::Vector3d& gyro_bias() const = 0;          ///< found so far, rad/s
  virtual std::uint64_t rejected() const = 0;                    ///< values outside the gate
  virtual navigation::InnovationTally taken() const = 0;         ///< innovations inside it
  virtual void fill(NavigationEstimate& estimate) const = 0;     ///< state, covariance, current
};

/// Of a filter's first nine errors, rad rad m, m/s, rad: eq. (14) of docs/estimators/navigation.md.
void fill_navigation(const navigation::NavigationState& state,
                     const Eigen::Matrix<double, 9, 9>& errors, NavigationEstimate& estimate);

/// Throws std::invalid_argument (one line) for a vehicle whose mass matrix is none.
std::unique_ptr<AidedInertial> make_aided_inertial(const InertialOptions& options);

}  // namespace drydock::pipeline

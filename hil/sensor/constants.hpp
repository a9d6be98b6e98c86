#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>

#include "rig_config/sensor_errors.hpp"

/// The parts of a sensor that are constant during a run: the constants of its model equation (IEEE
/// Std 952 and 1293) and their effect on an input.
namespace drydock::sensor {

using Eigen::Vector3d;

inline Vector3d vector(const rig_config::Axes& a) { return {a[0], a[1], a[2]}; }

/// (y, z, x) and (z, x, y): the next and the previous axis for each axis of a triad.
inline Vector3d next_axis(const Vector3d& v) { return {v.y(), v.z(), v.x()}; }
inline Vector3d previous_axis(const Vector3d& v) { return {v.z(), v.x(), v.y()}; }

struct Disturbance;

/// Identifies the errors of one sensor in one run. The random numbers of a part depend on these
/// names and its own.
struct ErrorSource {
  std::uint64_t seed = 1;
  std::string_view device;                   ///< or another name of the sensor
  std::string_view quantity;                 ///< "primary", "secondary"
  bool fixed_constants = true;               ///< true: +1 sigma; false: drawn once
  const Disturbance* disturbance = nullptr;  ///< effect of faults; must outlive the models

  std::string stream(std::string_view part) const {
    return std::string(quantity) + " " + std::string(part);
  }
  Vector3d constant(const rig_config::Axes& sigma, std::string_view part) const;
};

/// docs/sensors/errors.md (2) to (5): scale factor, asymmetry, non-linearity and misalignment.
class Response {
 public:
  Response(const rig_config::SensorErrors& errors, const ErrorSource& source);

  Vector3d error(const Vector3d& input) const {
    return linear_ * input + half_asymmetry_.cwiseProduct(input.cwiseAbs()) +
           nonlinearity_.cwiseProduct(input.cwiseAbs2());
  }
  bool is_ideal() const;

 private:
  Eigen::Matrix3d linear_;  ///< scale factors on the diagonal, small angles off it
  Vector3d half_asymmetry_, nonlinearity_;
};

/// docs/sensors/errors.md (6) and (7): the effect of the other triad's quantity and of the specific
/// force on an IMU's triad, in the sensor's axes.
class Coupling {
 public:
  Coupling(const rig_config::SensorErrors& errors, const ErrorSource& source);

  Vector3d of_gyro(const Vector3d& force) const {
    return sensitivity_.cwiseProduct(force) + spin_sensitivity_.cwiseProduct(previous_axis(force)) +
           anisoelastic(force);
  }
  Vector3d of_accelerometer(const Vector3d& force, const Vector3d& rate) const {
    return sensitivity_.cwiseProduct(next_axis(rate)) + anisoelastic(force);
  }
  bool is_ideal() const;

 private:
  Vector3d anisoelastic(const Vector3d& force) const {
    return anisoelasticity_.cwiseProduct(force).cwiseProduct(previous_axis(force));
  }

  Vector3d sensitivity_, spin_sensitivity_, anisoelasticity_;
};

}  // namespace drydock::sensor

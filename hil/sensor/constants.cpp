#include "hil/sensor/constants.hpp"

#include "hil/sensor/random.hpp"

namespace drydock::sensor {

Vector3d ErrorSource::constant(const rig_config::Axes& sigma, std::string_view part) const {
  if (fixed_constants) return vector(sigma);
  return vector(sigma).cwiseProduct(RandomStream(seed, device, stream(part)).normal3());
}

Response::Response(const rig_config::SensorErrors& errors, const ErrorSource& source)
    : linear_(source.constant(errors.scale_factor, "scale factor").asDiagonal()),
      half_asymmetry_(source.constant(errors.asymmetry, "asymmetry") / 2),
      nonlinearity_(source.constant(errors.nonlinearity, "nonlinearity")) {
  const Vector3d to_next = source.constant(errors.misalignment, "misalignment to the next axis");
  const Vector3d to_previous =
      source.constant(errors.misalignment, "misalignment to the previous axis");
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    linear_(axis, (axis + 1) % 3) = to_next[axis];
    linear_(axis, (axis + 2) % 3) = to_previous[axis];
  }
}

bool Response::is_ideal() const {
  return linear_.isZero(0) && half_asymmetry_.isZero(0) && nonlinearity_.isZero(0);
}

Coupling::Coupling(const rig_config::SensorErrors& errors, const ErrorSource& source)
    : sensitivity_(source.constant(errors.sensitivity, "sensitivity")),
      spin_sensitivity_(source.constant(errors.sensitivity, "sensitivity along the spin axis")),
      anisoelasticity_(source.constant(errors.anisoelasticity, "anisoelasticity")) {}

bool Coupling::is_ideal() const {
  return sensitivity_.isZero(0) && spin_sensitivity_.isZero(0) && anisoelasticity_.isZero(0);
}

}  // namespace drydock::sensor

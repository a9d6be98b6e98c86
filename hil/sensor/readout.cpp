#include "hil/sensor/readout.hpp"

#include <cmath>
#include <limits>

namespace drydock::sensor {

Readout::Readout(const rig_config::SensorErrors& errors)
    : range_(vector(errors.range)),
      step_(vector(errors.quantisation)),
      saturates_(!range_.isZero(0)),
      quantises_(!step_.isZero(0)),
      carried_(errors.quantisation_carried) {
  for (double& limit : range_)
    if (limit == 0) limit = std::numeric_limits<double>::infinity();
}

Vector3d Readout::of(const Vector3d& reading) {
  Vector3d out = reading;
  if (saturates_) out = out.cwiseMax(-range_).cwiseMin(range_);
  if (quantises_)
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      if (step_[axis] > 0) out[axis] = rounded(out[axis], step_[axis], rest_[axis]);
  return out;
}

double Readout::rounded(double value, double step, double& rest) const {
  const double whole = step * std::round((value + rest) / step);
  if (carried_) rest += value - whole;
  return whole;
}

}  // namespace drydock::sensor

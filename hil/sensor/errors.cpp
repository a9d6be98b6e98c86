#include "hil/sensor/errors.hpp"

namespace drydock::sensor {

ErrorModel::ErrorModel(const rig_config::SensorErrors& errors, double rate_hz,
                       const ErrorSource& source)
    : bias_(source.constant(errors.bias, "bias")),
      response_(errors, source),
      noise_(errors, rate_hz, source),
      drift_(errors, source),
      readout_(errors),
      responds_(!response_.is_ideal()),
      noisy_(!noise_.is_silent()),
      drifts_(!drift_.is_silent()),
      reads_out_(!readout_.is_ideal()) {}

Vector3d ErrorModel::read(const Vector3d& ideal, Stamp valid_at, const Vector3d& induced,
                          int axes) {
  Vector3d reading = ideal + bias_ + induced;
  if (responds_) reading += response_.error(ideal);
  if (drifts_) reading += drift_.at(valid_at, axes);
  if (noisy_) reading += noise_.next(axes);
  return reads_out_ ? readout_.of(reading) : reading;
}

}  // namespace drydock::sensor

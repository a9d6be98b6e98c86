#include "hil/sensor/errors.hpp"

#include <algorithm>

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
      reads_out_(!readout_.is_ideal()),
      disturbance_(source.disturbance),
      spikes_(source.seed, source.device, source.stream("spikes")) {}

Vector3d ErrorModel::read(const Vector3d& ideal, Stamp valid_at, const Vector3d& induced,
                          int axes) {
  Vector3d reading = ideal + bias_ + induced;
  if (responds_) reading += response_.error(ideal);
  if (drifts_) reading += drift_.at(valid_at, axes);
  if (noisy_) reading += (disturbance_ ? disturbance_->noise_times : 1) * noise_.next(axes);
  if (disturbance_ && !disturbance_->none()) reading = disturbed(ideal, reading, valid_at);
  reading = reads_out_ ? readout_.of(reading) : reading;
  if (disturbance_ && !disturbance_->stuck) last_error_ = reading - ideal;
  return reading;
}

Vector3d ErrorModel::disturbed(const Vector3d& ideal, const Vector3d& reading, Stamp valid_at) {
  const Disturbance& fault = *disturbance_;
  if (fault.stuck) return ideal + last_error_;
  Vector3d value = reading + fault.bias;
  if (fault.drift) {
    const double part = std::chrono::duration<double>(valid_at - fault.drift->since) /
                        std::chrono::duration<double>(fault.drift->within);
    value += std::clamp(part, 0.0, 1.0) * fault.drift->amount;
  }
  if (fault.wrong) value = *fault.wrong;
  if (fault.spike_probability > 0 && spikes_.uniform() < fault.spike_probability)
    value += fault.spike;
  return value;
}

}  // namespace drydock::sensor

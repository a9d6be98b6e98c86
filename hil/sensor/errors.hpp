#pragma once

#include "hil/sensor/disturbance.hpp"
#include "hil/sensor/noise.hpp"
#include "hil/sensor/readout.hpp"

namespace drydock::sensor {

/// All errors of one quantity (docs/sensors/errors.md (1)): a constant bias, the response to the
/// input, drift, white noise, then the converter. A part that is not configured costs one branch
/// and draws no random number. The random numbers of a part do not depend on the other parts.
class ErrorModel {
 public:
  /// `rate_hz` is the sample rate. It sets the white noise if that is given as a density.
  ErrorModel(const rig_config::SensorErrors& errors, double rate_hz, const ErrorSource& source);

  /// The reading for `ideal`. `valid_at` must not decrease. `induced` is an additional error at the
  /// input, such as the coupling between the triads of an IMU.
  Vector3d apply(const Vector3d& ideal, Stamp valid_at,
                 const Vector3d& induced = Vector3d::Zero()) {
    return read(ideal, valid_at, induced, 3);
  }
  double apply(double ideal, Stamp valid_at) {  ///< for a scalar quantity: the first axis
    return read({ideal, 0, 0}, valid_at, Vector3d::Zero(), 1).x();
  }

  const Vector3d& bias() const { return bias_; }

 private:
  Vector3d read(const Vector3d& ideal, Stamp valid_at, const Vector3d& induced, int axes);
  Vector3d disturbed(const Vector3d& ideal, const Vector3d& reading, Stamp valid_at);

  Vector3d bias_;
  Response response_;
  WhiteNoise noise_;
  Drift drift_;
  Readout readout_;
  bool responds_, noisy_, drifts_, reads_out_;
  const Disturbance* disturbance_;
  RandomStream spikes_;
  Vector3d last_error_ = Vector3d::Zero();
};

}  // namespace drydock::sensor

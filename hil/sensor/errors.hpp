#pragma once

#include "hil/sensor/disturbance.hpp"
#include "hil/sensor/noise.hpp"
#include "hil/sensor/readout.hpp"

namespace drydock::sensor {

/// All errors of one quantity (docs/sensors/errors.md (1)): a constant bias, the response to the
/// input, drift, white noise, then the converter. A part that is not configured costs a branch and
/// draws no random number; one part's numbers do not depend on another's being there.
class ErrorModel {
 public:
  /// `rate_hz`: of the samples; white noise given as a density depends on it.
  ErrorModel(const rig_config::SensorErrors& errors, double rate_hz, const ErrorSource& source);

  /// The reading of `ideal`. `valid_at` never goes back. `induced`: a further error at the input,
  /// as an IMU's triads have of each other.
  Vector3d apply(const Vector3d& ideal, Stamp valid_at,
                 const Vector3d& induced = Vector3d::Zero()) {
    return read(ideal, valid_at, induced, 3);
  }
  double apply(double ideal, Stamp valid_at) {  ///< of a scalar quantity: the first axis
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

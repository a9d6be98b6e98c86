#pragma once

#include "hil/sensor/constants.hpp"

namespace drydock::sensor {

/// The effect of the converter on a reading: saturation, then steps (docs/sensors/errors.md (11) to
/// (13)).
class Readout {
 public:
  explicit Readout(const rig_config::SensorErrors& errors);

  Vector3d of(const Vector3d& reading);
  bool is_ideal() const { return !saturates_ && !quantises_; }

 private:
  double rounded(double value, double step, double& rest) const;

  Vector3d range_, step_;
  bool saturates_, quantises_, carried_;
  Vector3d rest_ = Vector3d::Zero();  ///< rounding remainder of the last sample, if it is carried
};

}  // namespace drydock::sensor

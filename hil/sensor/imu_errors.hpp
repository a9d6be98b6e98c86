#pragma once

#include "drivers/measurement/measurement.hpp"
#include "hil/sensor/errors.hpp"
#include "rig_config/emulate.hpp"

namespace drydock::sensor {

/// The errors of an inertial unit: a gyro and an accelerometer triad with coupling between them. In
/// the unit's own axes. It needs no device: a study makes one per run from a grade, a seed and a
/// name.
class ImuErrors {
 public:
  struct Disturbances {  ///< effects of faults on the triads; must outlive the errors
    const Disturbance *gyro = nullptr, *accelerometer = nullptr;
  };

  ImuErrors(const rig_config::EmulateConfig& grade, double rate_hz, std::uint64_t seed,
            std::string_view name, const Disturbances& faults);
  ImuErrors(const rig_config::EmulateConfig& grade, double rate_hz, std::uint64_t seed,
            std::string_view name)
      : ImuErrors(grade, rate_hz, seed, name, {}) {}

  /// The unit's output for an ideal sample. Samples come in time order.
  measurement::ImuSample apply(const measurement::ImuSample& ideal);

 private:
  Coupling gyro_coupling_, accelerometer_coupling_;
  ErrorModel gyro_, accelerometer_;
  bool coupled_;
};

}  // namespace drydock::sensor

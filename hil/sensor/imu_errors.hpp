#pragma once

#include "drivers/measurement/measurement.hpp"
#include "hil/sensor/errors.hpp"
#include "rig_config/emulate.hpp"

namespace drydock::sensor {

/// An inertial unit's errors: a gyro and an accelerometer triad that feel each other's quantity. In
/// the unit's own axes. Needs no device: a study makes one per run from a grade, a seed and a name.
class ImuErrors {
 public:
  struct Disturbances {  ///< what faults make of the triads; outlive the errors
    const Disturbance *gyro = nullptr, *accelerometer = nullptr;
  };

  ImuErrors(const rig_config::EmulateConfig& grade, double rate_hz, std::uint64_t seed,
            std::string_view name, const Disturbances& faults);
  ImuErrors(const rig_config::EmulateConfig& grade, double rate_hz, std::uint64_t seed,
            std::string_view name)
      : ImuErrors(grade, rate_hz, seed, name, {}) {}

  /// What the unit reports of an ideal sample; samples come in time order.
  measurement::ImuSample apply(const measurement::ImuSample& ideal);

 private:
  Coupling gyro_coupling_, accelerometer_coupling_;
  ErrorModel gyro_, accelerometer_;
  bool coupled_;
};

}  // namespace drydock::sensor

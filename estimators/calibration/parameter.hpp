#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "estimators/smoothing/reading.hpp"
#include "estimators/smoothing/sensor_model.hpp"

namespace drydock::calibration {

/// What may be wrong about a device. Each is a change of what the rig says.
enum class Unknown : std::uint8_t {
  yaw,          ///< of its mounting, rad
  pitch,        ///< of its mounting, rad
  scale,        ///< of its velocity; for a DVL that of the speed of sound
  latency,      ///< s, or how far its clock is behind
  lever_ahead,  ///< m
  lever_starboard,
  deviation_constant,  ///< of a compass, rad
  deviation_sine,      ///< times the sine of the heading
  deviation_cosine
};

/// One number to find. `prior_sigma` is what may be expected before the dive, 1 sigma.
struct Parameter {
  std::uint16_t device = 0;
  Unknown unknown = Unknown::yaw;
  double prior_sigma = 1;
};

/// The name and unit for a person.
std::string_view name_of(Unknown unknown);
std::string_view unit_of(Unknown unknown);
/// The usual prior: yaw and pitch 5 degrees, scale 5 %, latency .5 s, lever 1 m, deviation 5
/// degrees.
double usual_prior(Unknown unknown);

/// Sets the value in the model of its device.
void apply(const Parameter& parameter, double value, smoothing::SensorModels& models);

/// All that a dive with these readings may tell: of each DVL, log, compass and depth sensor; their
/// latencies are against the receiver. The constant of a compass is left out beside a DVL, whose
/// yaw holds it: only their sum moves the track.
std::vector<Parameter> parameters_of(const smoothing::Dive& dive);

}  // namespace drydock::calibration

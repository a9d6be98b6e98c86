#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "drivers/measurement/measurement.hpp"

/// Measurements as plain numbers, so that those of two runs can be held against each other.
namespace drydock::scorecard {

/// What kind of number it is: under some faults another one is the truth.
enum class Role : std::uint8_t {
  value,    ///< what the sensor measures
  quality,  ///< what it says of how well: signal strength, accuracy, number of satellites
  clock,    ///< the device's own time
  total     ///< a sum since power-up: what once went in stays
};

struct Field {
  std::uint32_t series = 0;  ///< the same number of one device in every message
  std::string_view name;
  double value = 0;  ///< SI, radians
  Role role = Role::value;
  bool angle = false;  ///< goes round at pi
};

/// All numbers of a measurement that are there; times in seconds since `start`.
void fields_of(const measurement::Measurement& m, measurement::Stamp start,
               std::vector<Field>& out);

}  // namespace drydock::scorecard

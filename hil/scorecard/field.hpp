#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "drivers/measurement/measurement.hpp"

/// Measurements as plain numbers, so that two runs can be compared.
namespace drydock::scorecard {

/// The role of a number. It decides which value is the truth under a fault.
enum class Role : std::uint8_t {
  value,    ///< what the sensor measures
  quality,  ///< what the sensor reports about its quality: signal strength, accuracy, number of
            ///< satellites
  clock,    ///< the device's own time
  total     ///< a sum since power-up: an error in it stays
};

struct Field {
  std::uint32_t series = 0;  ///< identifies the same number of one device in every message
  std::string_view name;
  double value = 0;  ///< SI, radians
  Role role = Role::value;
  bool angle = false;  ///< wraps at pi
};

/// All numbers that a measurement contains. Times are in seconds since `start`.
void fields_of(const measurement::Measurement& m, measurement::Stamp start,
               std::vector<Field>& out);

}  // namespace drydock::scorecard

#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "rig_config/emulate.hpp"
#include "rig_config/rig.hpp"

namespace drydock::characterize {

/// A quantity of a sensor file: how it is shown, and what counts as standing still.
struct Quantity {
  std::string_view name;  ///< "gyro"
  rig_config::SensorErrors rig_config::EmulateConfig::*errors;
  int place = 0;  ///< in Samples::quantities
  std::array<std::string_view, 3> axes;
  std::string_view unit;    ///< of figures in the reports
  double in_si = 1;         ///< one such unit
  double change = 0;        ///< SI: slower and smaller drift of the reading is no motion
  bool by_density = false;  ///< its file states white noise as a density
  bool walks = false;       ///< its file has a random walk
};

/// Those of a kind of device.
std::vector<Quantity> quantities_of(rig_config::DeviceKind kind);

}  // namespace drydock::characterize

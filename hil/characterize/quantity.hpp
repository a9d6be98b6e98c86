#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "rig_config/emulate.hpp"
#include "rig_config/rig.hpp"

namespace drydock::characterize {

/// A quantity of a sensor file: how it is shown, and when its input counts as constant.
struct Quantity {
  std::string_view name;  ///< "gyro"
  rig_config::SensorErrors rig_config::EmulateConfig::*errors;
  int place = 0;  ///< index in Samples::quantities
  std::array<std::string_view, 3> axes;
  std::string_view unit;    ///< for figures in the reports
  double in_si = 1;         ///< one such unit in SI
  double change = 0;        ///< SI: a smaller change of the reading is drift, not motion
  bool by_density = false;  ///< the file states white noise as a density
  bool walks = false;       ///< the file has a random walk
};

/// The quantities of a kind of device.
std::vector<Quantity> quantities_of(rig_config::DeviceKind kind);

}  // namespace drydock::characterize

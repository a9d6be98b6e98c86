#pragma once

#include <functional>
#include <string>

#include "rig_config/rules/error_keys.hpp"

namespace drydock::rig_config {

/// What stands behind a key's line, without '#'; empty: nothing.
using KeyComment = std::function<std::string(const ErrorKey&)>;

/// A sensor file of one table that load_sensor() reads as `grade`, but for rounding to seven
/// digits: what is zero is left out. `head`: comment lines at the top, each without '#'.
std::string sensor_text(DeviceKind kind, const EmulateConfig& grade, const std::string& head,
                        const KeyComment& comment);

/// Three figures in the key's unit: "0.5", or "[0.5, 0.4, 0.6]" where they differ.
std::string figures_text(const Axes& si, double unit, int digits);

}  // namespace drydock::rig_config

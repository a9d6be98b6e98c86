#pragma once

#include <functional>
#include <string>

#include "rig_config/rules/error_keys.hpp"

namespace drydock::rig_config {

/// The comment at the end of the line of a key, without '#'. Empty: no comment.
using KeyComment = std::function<std::string(const ErrorKey&)>;

/// A sensor file with one table. load_sensor() reads it as `grade`, rounded to seven digits. Keys
/// with the value zero are left out. `head`: comment lines at the top, each without '#'.
std::string sensor_text(DeviceKind kind, const EmulateConfig& grade, const std::string& head,
                        const KeyComment& comment);

/// Three figures in the unit of the key: "0.5", or "[0.5, 0.4, 0.6]" if they differ.
std::string figures_text(const Axes& si, double unit, int digits);

}  // namespace drydock::rig_config

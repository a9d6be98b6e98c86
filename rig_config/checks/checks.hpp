#pragma once

#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// Path of a file that `file` names relative to its own folder.
std::string beside(const std::string& file, const std::string& relative);

/// What a schema cannot say of a rig: names used twice, an estimator's devices, link URIs,
/// addresses taken twice on one bus, files that are not there. Holds for incomplete documents too.
Problems check_rig(const Node& root, const std::string& file, const LoadOptions& options);

/// Of blocks [[expect]]: names that exist, bounds in order, figures that the kind of estimator has.
Problems check_expects(const Node& root, const std::string& file);

/// Of blocks [[fault]]: keys that the fault has, amounts in range. Whether the device can have it:
/// check_faults_of().
Problems check_faults(const Node& root, const std::string& file);

/// What a schema cannot say of a mission: it stays in the water, depths of profiles rise, raster
/// and vehicle file are there, only a vehicle is steered by its rudder, only a kinematic one heels
/// as told.
Problems check_mission(const Node& root, const std::string& file);

}  // namespace drydock::rig_config

#pragma once

#include <filesystem>

#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// The path without "." and "..", unless that names another file: behind a symlink ".." is not the
/// folder before it.
std::filesystem::path short_name(const std::filesystem::path& path);

/// The path of a file that `file` names relative to the folder of `file`.
std::string beside(const std::string& file, const std::string& relative);

/// Checks of a rig that a schema cannot express: names used twice, devices of an estimator, link
/// URIs, addresses used twice on one bus, missing files. Works for incomplete documents too.
Problems check_rig(const Node& root, const std::string& file, const LoadOptions& options);

/// The tables of a group, "device" or "thruster", must have a name each.
Problems check_names(const Node& root, const std::string& file, const char* group);

/// Checks of the blocks [[expect]]: names must exist, bounds must be in order, and the kind of
/// estimator must have the figures.
Problems check_expects(const Node& root, const std::string& file);

/// Checks of the blocks [[fault]]: the fault must have the keys, and amounts must be in range.
/// check_faults_of() checks whether the device can have the fault.
Problems check_faults(const Node& root, const std::string& file);

/// Checks of a mission that a schema cannot express: it stays in the water; depths of profiles
/// increase; raster and vehicle file exist; a rudder needs a vehicle; a prescribed heel needs a
/// mission without one.
Problems check_mission(const Node& root, const std::string& file);

/// Checks of a mission against its vehicle: who sails one with thrusters, and how it begins.
Problems check_steering(const Node& root, const std::string& file, const MissionConfig& mission);

/// Checks of the actuators of a rig, whose mission is loaded: the vehicle must have what they move.
Problems check_drives(const Node& root, const std::string& file, const Rig& rig);

/// Two described sensors that are polled on one link need answers that begin differently: an answer
/// does not say whose question it is for.
Problems check_polled_lines(const Node& root, const std::string& file,
                            const std::vector<DeviceConfig>& devices);

}  // namespace drydock::rig_config

#pragma once

#include <string>

#include "hil/check/check_rig.hpp"
#include "rig_config/device_description/load_description.hpp"
#include "rig_config/rig.hpp"

namespace drydock::program {

/// Thrown when a rig file cannot be used, after the lines that say why have been printed.
struct BadRig {};

/// Reads a rig file, or the shipped rig of that name, with the environment's DDS domain. Throws
/// BadRig for a rig that cannot be used so, with the lines of `drydock check`.
rig_config::Rig load_rig(const std::string& path, check::Use use = check::Use::any);

/// True for a rig file or the name of a shipped rig; false for what may be a link or a recording.
bool names_rig(const std::string& source);

/// Puts the faults of a file beside those of the rig and checks all of them. An empty path: those
/// of the rig alone. Throws BadRig where the file is wrong or the rig cannot have such a fault.
void add_faults(rig_config::Rig& rig, const std::string& path);

/// The description that a name of a protocol means, from the working folder or built in. Null: the
/// name is of the registry. Throws BadRig for a description that cannot be used, and for a name
/// that looks like another one.
rig_config::DescriptionPtr load_protocol(const std::string& protocol);

}  // namespace drydock::program

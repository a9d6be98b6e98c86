#pragma once

#include <string>

#include "drivers/wire/described/plan.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// The checksum that the word at this path names: a plain one, a CRC by its name in the catalogue,
/// or a CRC by its parameters.
void read_checksum(const Node& word, const std::string& path, wire::described::Checksum& into,
                   const std::string& file, Problems& problems);

}  // namespace drydock::rig_config

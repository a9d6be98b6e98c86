#pragma once

#include <string>

#include "drivers/wire/described/plan.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// The checksum that the word names: a plain one, a CRC by its name in the catalogue, or a CRC by
/// its parameters.
void read_checksum(const Node& protocol, const std::string& word, wire::described::Checksum& into,
                   const std::string& file, Problems& problems);

}  // namespace drydock::rig_config

#pragma once

#include <string_view>

#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// Parses TOML. Problems: bad syntax, a local date-time (no offset), nan and inf.
Loaded<Node> read_toml(std::string_view text, const std::string& path);

}  // namespace drydock::rig_config

#pragma once

#include <string_view>

#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// Parses TOML. It refuses bad syntax, date-times without an offset, nan and inf, and values beyond
/// the limits of toml_limits.hpp.
Loaded<Node> read_toml(std::string_view text, const std::string& path);

}  // namespace drydock::rig_config

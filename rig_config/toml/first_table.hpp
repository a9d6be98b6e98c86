#pragma once

#include <string>

#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// A file without the table that says of which kind it is: `what` at the key that looks like its
/// name, with the name, or at the begin of the file. `table` is empty for a kind with several.
Problem without_first_table(const Node& root, const std::string& file, const std::string& table,
                            const std::string& what);

}  // namespace drydock::rig_config

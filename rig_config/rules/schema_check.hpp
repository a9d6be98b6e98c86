#pragma once

#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// What a JSON Schema (its text) does not allow in a document, in no particular order.
Problems check_schema(const Node& root, const std::string& file, std::string_view schema_text);

}  // namespace drydock::rig_config

#pragma once

#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// The problems of a document against a JSON Schema (given as text), in no particular order.
Problems check_schema(const Node& root, const std::string& file, std::string_view schema_text);

}  // namespace drydock::rig_config

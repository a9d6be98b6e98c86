#pragma once

#include <span>

#include "drivers/wire/protocols.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// The problems of a document against a JSON Schema (given as text), in no particular order. The
/// lists of protocols also have those that files describe.
Problems check_schema(const Node& root, const std::string& file, std::string_view schema_text,
                      std::span<const wire::Protocol> described = {});

}  // namespace drydock::rig_config

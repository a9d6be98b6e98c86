#pragma once

#include "rig_config/places.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// The places of all values of a document.
PlacesPtr places_of(const Node& root, const std::string& file);

}  // namespace drydock::rig_config

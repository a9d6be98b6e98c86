#pragma once

#include "hil/campaign/plan/parameter.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::campaign {

/// A block [[parameter]] that passed the schema. `problems` gets what a schema cannot say; the
/// value is then of no use.
ParameterConfig read_parameter(const rig_config::Node& table, const std::string& file,
                               rig_config::Problems& problems);

}  // namespace drydock::campaign

#pragma once

#include <nlohmann/json_fwd.hpp>

namespace drydock::rig_config {

/// The schema with its lists of protocols, made from the table of protocols: every part with the
/// key "protocols" becomes an "enum". Its value says which protocols: a kind of sensor, "all"
/// (those with a kind), "bytes", "frames" or "canopen".
nlohmann::json with_protocol_lists(nlohmann::json schema);

}  // namespace drydock::rig_config

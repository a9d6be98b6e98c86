#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "drivers/wire/protocols.hpp"

namespace drydock::rig_config {

/// The schema with its lists of protocols, made from the table of protocols: every part with the
/// key "protocols" becomes an "enum". Its value says which protocols: a kind of sensor, "all"
/// (those with a kind), "bytes", "frames" or "canopen". `described`: protocols that files add.
nlohmann::json with_protocol_lists(nlohmann::json schema,
                                   std::span<const wire::Protocol> described = {});

}  // namespace drydock::rig_config

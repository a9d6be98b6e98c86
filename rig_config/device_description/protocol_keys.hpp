#pragma once

#include "drivers/wire/described/plan.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// Reads what [protocol] says of all its messages: checksums, ends, stuffing, decimals. The form is
/// in `plan` already.
void read_protocol_keys(const Node& protocol, wire::described::Plan& plan, const std::string& file,
                        Problems& problems);

/// True if numbers of several bytes have their high byte first.
bool is_big_endian(const Node& protocol);

/// What stands behind a field of a text, unless the field says otherwise.
char separator_of(const Node& protocol);

}  // namespace drydock::rig_config

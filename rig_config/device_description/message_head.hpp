#pragma once

#include "drivers/wire/described/plan.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// How a frame begins and where it ends: sync, length, and what its CRC takes in.
void read_binary_head(const Node& protocol, const Node& table, const wire::described::Plan& plan,
                      wire::described::Message& message, const std::string& file,
                      const std::string& path, Problems& problems);

/// How a sentence or a line begins: id or head, and from it the message's name.
void read_text_head(const Node& protocol, const Node& table, const wire::described::Plan& plan,
                    wire::described::Message& message, const std::string& file,
                    const std::string& path, Problems& problems);

}  // namespace drydock::rig_config

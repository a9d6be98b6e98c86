#pragma once

#include "drivers/wire/described/description.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// The description of a document that passed the schema. Problems are appended: then it is not
/// usable.
wire::described::Description read_description(const Node& root, const std::string& file,
                                              Problems& problems);

/// Pairs of messages that the same bytes could be, and fields outside their frame. `tables`: those
/// of the messages, in their order.
Problems check_plan(const wire::described::Plan& plan, std::span<const Node> tables,
                    const std::string& file, const std::string& path);

/// Samples that can never be whole: forces without rates, a velocity or quaternion without a
/// component.
Problems check_whole(const wire::described::Description& description, std::span<const Node> tables,
                     const std::string& file, const std::string& path);

/// Lines whose `emulate` makes a text that is not their message.
Problems check_emulated(const wire::described::Plan& plan, std::span<const Node> tables,
                        const std::string& file, const std::string& path);

}  // namespace drydock::rig_config

#pragma once

#include "drivers/wire/described/frame_plan.hpp"
#include "drivers/wire/described/plan.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// Reads what a table of `[[protocol.frames]]` says of its message besides the fields: sample,
/// counter, checksum. `fields` are those read from it. Problems are appended.
void read_frame(const Node& table, std::span<const wire::described::Field> fields,
                wire::described::FrameLayout& layout, const std::string& file,
                const std::string& path, Problems& problems);

/// Contradictions between the messages of one sample. `tables`: those of the messages.
Problems check_samples(const wire::described::Plan& plan, const wire::described::FramePlan& frames,
                       std::span<const Node> tables, const std::string& file);

}  // namespace drydock::rig_config

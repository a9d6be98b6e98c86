#pragma once

#include "drivers/wire/described/description.hpp"
#include "drivers/wire/described/frame_plan.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// The plan of the messages that `[[protocol.frames]]` names, from the DBC file of `[protocol]`,
/// whose path goes to `description.dbc_file`. Null after a problem.
std::shared_ptr<wire::described::FramePlan> plan_frames(const Node& root,
                                                        wire::described::Description& description,
                                                        const std::string& file,
                                                        Problems& problems);

/// How long the frames of one sample may take: `within_ms`, else half of the shortest cycle time.
void limit_samples(const Node& protocol, wire::described::FramePlan& frames);

}  // namespace drydock::rig_config

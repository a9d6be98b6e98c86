#pragma once

#include "hil/cli/commands/commands.hpp"

namespace drydock::cli {

/// scorecard: the effect of every fault on every device.
void add_scorecard_command(CLI::App& app, Command& command);

}  // namespace drydock::cli

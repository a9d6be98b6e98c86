#pragma once

#include "hil/program/commands.hpp"

namespace drydock::program {

/// scorecard: the effect of every fault on every device.
void add_scorecard_command(CLI::App& app, Command& command);

}  // namespace drydock::program

#pragma once

#include "hil/program/commands.hpp"

namespace drydock::program {

/// scorecard: what every fault does to every device.
void add_scorecard_command(CLI::App& app, Command& command);

}  // namespace drydock::program

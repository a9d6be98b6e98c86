#pragma once

#include <CLI/CLI.hpp>

namespace drydock::program {

/// Lets each option of a command that names a file of text take `-` (dash_output.hpp).
void take_dashes(CLI::App& app);

/// Throws CLI::ValidationError where the chosen command would write over a file that it reads, two
/// outputs into one file, or, without --overwrite, over a file that no earlier run of it can have
/// written: a recording, a rig. Devices and pipes take anything.
void spare_files(const CLI::App& app);

}  // namespace drydock::program

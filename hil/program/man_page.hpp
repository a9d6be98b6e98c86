#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace drydock::program {

/// drydock(1) in roff, made of the command line's own description.
std::string man_page(const CLI::App& app, const std::string& version);

}  // namespace drydock::program

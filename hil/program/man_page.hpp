#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace drydock::program {

/// The page drydock(1) in roff, generated from the command line's own description.
std::string man_page(const CLI::App& app, const std::string& version);

}  // namespace drydock::program

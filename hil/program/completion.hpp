#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// Shell completion made of the command line's own description: subcommands, their options, the
/// values that an option allows, files for what takes one.
namespace drydock::program {

/// To be read by bash: `source <(drydock completion bash)`.
std::string bash_completion(const CLI::App& app);

/// To be stored as `_drydock` in a folder of zsh's fpath, or read once compinit has run:
/// `source <(drydock completion zsh)`.
std::string zsh_completion(const CLI::App& app);

}  // namespace drydock::program

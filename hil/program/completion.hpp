#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// Shell completion scripts, generated from the command line's own description: subcommands, their
/// options, the values that an option allows, and file names.
namespace drydock::program {

/// For bash: `source <(drydock completion bash)`.
std::string bash_completion(const CLI::App& app);

/// For zsh: stored as `_drydock` in a folder of fpath, or read after compinit with `source
/// <(drydock completion zsh)`.
std::string zsh_completion(const CLI::App& app);

}  // namespace drydock::program

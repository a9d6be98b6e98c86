#include <fmt/format.h>

#include <memory>

#include "hil/program/commands.hpp"
#include "hil/program/completion.hpp"

namespace drydock::program {

void add_completion(CLI::App& app, Command& command) {
  auto shell = std::make_shared<std::string>();
  auto* sub = app.add_subcommand("completion", "Print a completion script for a shell");
  sub->footer(
      "Example: source <(drydock completion bash)\n"
      "         drydock completion zsh > ~/.zfunc/_drydock");
  sub->add_option("SHELL", *shell, "which shell")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh"}));
  sub->callback([shell, &app, &command] {
    command = [shell, &app] {
      fmt::print("{}", *shell == "bash" ? bash_completion(app) : zsh_completion(app));
      return 0;
    };
  });
}

}  // namespace drydock::program

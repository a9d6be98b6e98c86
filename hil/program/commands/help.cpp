#include <fmt/format.h>

#include <memory>

#include "hil/program/commands.hpp"
#include "rig_config/rules/explain.hpp"

namespace drydock::program {

namespace {

/// The command that the words name, one below the other: `fault set`.
const CLI::App* command_named(const CLI::App* app, const std::vector<std::string>& words) {
  for (const auto& word : words) {
    const auto named =
        app->get_subcommands([&](const CLI::App* one) { return one->get_name() == word; });
    if (named.empty()) return nullptr;
    app = named.front();
  }
  return app;
}

std::string help_of(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty())
    return app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal);
  std::string before = app.get_name();
  for (std::size_t i = 0; i + 1 < words.size(); ++i) before += " " + words[i];
  if (const auto* named = command_named(&app, words)) return named->help(before);
  std::vector<std::string> names;
  for (const auto* one : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(one->get_name());
  throw CLI::ValidationError("COMMAND",
                             fmt::format("'{}' is no command{}", fmt::join(words, " "),
                                         rig_config::did_you_mean(words.front(), names)));
}

}  // namespace

void add_help(CLI::App& app, Command& command) {
  auto words = std::make_shared<std::vector<std::string>>();
  auto* sub = app.add_subcommand("help", "The help of a command, as its --help prints it");
  sub->footer("Example: drydock help run\n         drydock help fault set");
  sub->add_option("COMMAND", *words, "default: of all");
  sub->callback([words, &app, &command] {
    command = [words, &app] {
      fmt::print("{}", help_of(app, *words));
      return 0;
    };
  });
}

}  // namespace drydock::program

#include <fmt/format.h>

#include <csignal>

#include "drivers/terminal/dead_terminal.hpp"
#include "drivers/terminal/early_end.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/dash_output.hpp"
#include "hil/program/finish.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/misspelled.hpp"
#include "hil/program/outputs.hpp"
#include "hil/program/standard_streams.hpp"

namespace {

namespace program = drydock::program;
namespace terminal = drydock::terminal;

std::string description() {
  std::string codes;
  for (const auto& [code, meaning] : terminal::exit_codes)
    codes += fmt::format("{} {} {}", codes.empty() ? "Exit codes:" : ",", code, meaning);
  return "Drydock: a test rig for underwater navigation.\n" + codes + ".";
}

int wrong_usage(const std::string& line) {
  fmt::print(stderr, "{}\nRun with --help for more information.\n", line);
  return terminal::exit_usage;
}

/// A write that failed is told by program::finish, which knows why.
int failed(const CLI::App& app, const std::exception& error) {
  const auto typed = app.get_subcommands();
  const auto& name = typed.empty() ? app.get_name() : typed.front()->get_name();
  if (std::ferror(stdout) == 0) fmt::print(stderr, "{}: {}\n", name, error.what());
  return terminal::exit_failed;
}

/// Reads the command line and does what it says. Gives the exit code of the command.
int obey(CLI::App& app, program::Command& command, int argc, char** argv) try {
  if (const auto line = program::misspelled_command(app, argc, argv); !line.empty())
    return wrong_usage(line);
  app.parse(argc, argv);
  program::spare_files(app);
  program::begin_dash();
  return command();
} catch (const CLI::ExtrasError& error) {
  return wrong_usage(program::misspelled_option(app, error));
} catch (const CLI::RequiredError& error) {
  return wrong_usage(program::missing_word(app, error));
} catch (const CLI::ValidationError& error) {
  return wrong_usage(program::misspelled_value(error));
} catch (const CLI::ParseError& error) {
  return app.exit(error) == 0 ? terminal::exit_success : terminal::exit_usage;
} catch (const program::BadRig&) {
  return terminal::exit_usage;
} catch (const std::exception& error) {
  return failed(app, error);
}

}  // namespace

int main(int argc, char** argv) {
  program::guard_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file at its limit of size is told as a full disk is
  terminal::end_at_once_on_signals();
  terminal::hold_lines_of_pipe();
  CLI::App app{description()};
  app.name("drydock");
  app.set_version_flag("--version", DRYDOCK_VERSION);
  app.require_subcommand(1);
  app.footer("drydock COMMAND --help shows an example of each.");
  program::Command command;
  for (const auto add : program::commands()) add(app, command);
  program::take_dashes(app);
  const int code = obey(app, command, argc, argv);
  program::end_dash();
  return program::finish(code);
}

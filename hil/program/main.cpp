#include <fmt/format.h>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"

namespace {

std::string description() {
  std::string codes;
  for (const auto& [code, meaning] : drydock::terminal::exit_codes)
    codes += fmt::format("{} {} {}", codes.empty() ? "Exit codes:" : ",", code, meaning);
  return "Drydock: a test rig for underwater navigation.\n" + codes + ".";
}

}  // namespace

int main(int argc, char** argv) {
  namespace program = drydock::program;
  namespace terminal = drydock::terminal;
  CLI::App app{description()};
  app.name("drydock");
  app.set_version_flag("--version", DRYDOCK_VERSION);
  app.require_subcommand(1);
  app.footer("drydock COMMAND --help shows an example of each.");
  program::Command command;
  for (const auto add : program::commands()) add(app, command);
  try {
    app.parse(argc, argv);
    return command();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? terminal::exit_success : terminal::exit_usage;
  } catch (const program::BadRig&) {
    return terminal::exit_usage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "drydock: {}\n", error.what());
    return terminal::exit_failed;
  }
}

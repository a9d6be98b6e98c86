#include <fmt/format.h>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/scorecard_command.hpp"

int main(int argc, char** argv) {
  namespace cli = drydock::cli;
  CLI::App app{
      "Drydock: a test rig for underwater navigation.\n"
      "Exit codes: 0 success, 1 the run or the input failed, 2 wrong usage or configuration."};
  app.name("drydock");
  app.set_version_flag("--version", DRYDOCK_VERSION);
  app.require_subcommand(1);
  app.footer("drydock COMMAND --help shows an example of each.");
  cli::Command command;
  cli::add_rig_commands(app, command);
  cli::add_fault_command(app, command);
  cli::add_capture_commands(app, command);
  cli::add_field_commands(app, command);
  cli::add_recording_commands(app, command);
  cli::add_replay_command(app, command);
  cli::add_proxy_command(app, command);
  cli::add_world_commands(app, command);
  cli::add_characterize_command(app, command);
  cli::add_soak_command(app, command);
  cli::add_validity_command(app, command);
  cli::add_load_command(app, command);
  cli::add_scorecard_command(app, command);
  try {
    app.parse(argc, argv);
    return command();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : cli::exit_usage;
  } catch (const cli::BadRig&) {
    return cli::exit_usage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "drydock: {}\n", error.what());
    return cli::exit_failed;
  }
}

#include <fmt/format.h>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/scorecard_command.hpp"

int main(int argc, char** argv) {
  using namespace drydock;
  using namespace drydock::program;
  CLI::App app{
      "Drydock: a test rig for underwater navigation.\n"
      "Exit codes: 0 success, 1 the run or the input failed, 2 wrong usage or configuration."};
  app.name("drydock");
  app.set_version_flag("--version", DRYDOCK_VERSION);
  app.require_subcommand(1);
  app.footer("drydock COMMAND --help shows an example of each.");
  program::Command command;
  add_rig_commands(app, command);
  add_fault_command(app, command);
  add_capture_commands(app, command);
  add_field_commands(app, command);
  add_recording_commands(app, command);
  add_replay_command(app, command);
  add_proxy_command(app, command);
  add_world_commands(app, command);
  add_characterize_command(app, command);
  add_soak_command(app, command);
  add_validity_command(app, command);
  add_load_command(app, command);
  add_scorecard_command(app, command);
  try {
    app.parse(argc, argv);
    return command();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : terminal::exit_usage;
  } catch (const BadRig&) {
    return terminal::exit_usage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "drydock: {}\n", error.what());
    return terminal::exit_failed;
  }
}

#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "drivers/host/rig_viewer.hpp"
#include "rig_config/rig.hpp"

/// The command line of the program: subcommands and their options.
namespace drydock::program {

/// The chosen command. The callback of exactly one subcommand sets it; it returns the exit code.
using Command = std::function<int()>;

/// run, emulate, drive, estimate, check: commands that take a rig file.
void add_rig_commands(CLI::App& app, Command& command);

/// fault: sets and clears faults of a running bench.
void add_fault_command(CLI::App& app, Command& command);

/// decode: prints what one link carried.
void add_capture_commands(CLI::App& app, Command& command);

/// probe, monitor, doctor: examine a link, its health and this machine. completion, man: describe
/// the program.
void add_field_commands(CLI::App& app, Command& command);

/// export, recover, cut, bisect: work on recording files.
void add_recording_commands(CLI::App& app, Command& command);

/// replay: plays a recording through the drivers and estimators of its rig.
void add_replay_command(CLI::App& app, Command& command);

/// sensor, sky, maneuver, study: the emulated world and the papers, without links.
void add_world_commands(CLI::App& app, Command& command);

/// soak: runs a rig for a long time under random faults.
void add_soak_command(CLI::App& app, Command& command);

/// characterize: measures the quality of a sensor.
void add_characterize_command(CLI::App& app, Command& command);

/// Adds --serve and --token. `more` is appended to the help of --serve.
void add_serve(CLI::App& sub, host::ServeOptions& serve, const std::string& more = {});

/// validity: measures the accuracy of measurement times.
void add_validity_command(CLI::App& app, Command& command);

/// load: checks whether a machine keeps every deadline of a rig.
void add_load_command(CLI::App& app, Command& command);

/// proxy: puts faults between a real device and its drivers.
void add_proxy_command(CLI::App& app, Command& command);

/// A rig file that cannot be used. The problems have already been printed.
struct BadRig {};

/// Reads a rig file. ROS_DOMAIN_ID of the environment sets the DDS domain. Throws BadRig.
rig_config::Rig load_rig(const std::string& path);

/// Accepts "60s", "10min", "5.5h" and converts them to seconds.
extern const CLI::Validator duration_text;

}  // namespace drydock::program

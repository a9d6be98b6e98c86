#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "drivers/host/rig_viewer.hpp"
#include "rig_config/rig.hpp"

/// The command line of the program: its subcommands with their options.
namespace drydock::program {

/// What the command line chose: set by exactly one subcommand's callback. Gives the exit code.
using Command = std::function<int()>;

/// run, emulate, drive, estimate, check: a rig file and what it describes.
void add_rig_commands(CLI::App& app, Command& command);

/// fault: breaks a bench that runs, and mends it.
void add_fault_command(CLI::App& app, Command& command);

/// decode: what one link said.
void add_capture_commands(CLI::App& app, Command& command);

/// probe, monitor, doctor: what is on this wire, how is it, is this machine fit; completion, man:
/// the program itself.
void add_field_commands(CLI::App& app, Command& command);

/// export, recover, cut, bisect: recordings as files.
void add_recording_commands(CLI::App& app, Command& command);

/// replay: a recording through the drivers and estimators of its rig.
void add_replay_command(CLI::App& app, Command& command);

/// sensor, sky, maneuver, study: the emulated world and the papers, without wires.
void add_world_commands(CLI::App& app, Command& command);

/// soak: a rig for a long time under random faults.
void add_soak_command(CLI::App& app, Command& command);

/// characterize: what a sensor is worth.
void add_characterize_command(CLI::App& app, Command& command);

/// --serve and --token. `more` is added to the help of the first.
void add_serve(CLI::App& sub, host::ServeOptions& serve, const std::string& more = {});

/// validity: how right the times of measurements are.
void add_validity_command(CLI::App& app, Command& command);

/// load: whether a machine keeps every deadline of a rig.
void add_load_command(CLI::App& app, Command& command);

/// proxy: a real device with faults between it and its drivers.
void add_proxy_command(CLI::App& app, Command& command);

/// A rig file that cannot be used; the lines have been printed.
struct BadRig {};

/// Reads it, with the environment's DDS domain. Throws BadRig.
rig_config::Rig load_rig(const std::string& path);

/// Takes "60s", "10min", "5.5h" and gives seconds.
extern const CLI::Validator duration_text;

}  // namespace drydock::program

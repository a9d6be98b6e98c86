#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "drivers/host/rig_recorder.hpp"
#include "drivers/host/rig_viewer.hpp"
#include "drivers/io/scheduling.hpp"

/// Options that several commands have.
namespace drydock::program {

/// Takes "60s", "10min", "5.5h" and gives seconds.
extern const CLI::Validator duration_text;

/// The same for --for, which has to be longer than nothing.
extern const CLI::Validator running_time;

/// Takes a finite number above 0.
extern const CLI::Validator positive_number;

/// Takes a whole number of 64 bits without a sign.
extern const CLI::Validator seed_number;

/// Takes a rig file or the name of a shipped rig, and gives the path of the file.
extern const CLI::Validator rig_name;

/// --serve and --token. `more` is added to the help of --serve.
void add_serve(CLI::App& sub, host::ServeOptions& serve, const std::string& more = {});

/// --allow-faults, beside --serve.
void add_allow_faults(CLI::App& sub, host::ServeOptions& serve);

/// --allow-recording, beside --serve.
void add_allow_recording(CLI::App& sub, host::ServeOptions& serve);

/// --faults: a file of blocks [[fault]].
void add_faults_option(CLI::App& sub, std::string& file);

/// --overwrite, --split-size, --split-every and --keep, for a recording.
void add_recording(CLI::App& sub, host::RecordOptions& record);

/// What --realtime, --priority and --cores ask for.
struct RealtimeOptions {
  bool wanted = false;
  io::Scheduling scheduling;
};
void add_realtime(CLI::App& sub, RealtimeOptions& realtime);

/// Does what they ask for, and says so on standard error. Throws CLI::ValidationError if the kernel
/// refuses it.
void claim(const RealtimeOptions& realtime);

}  // namespace drydock::program

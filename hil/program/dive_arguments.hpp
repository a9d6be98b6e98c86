#pragma once

#include "hil/program/capture_arguments.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/named_file.hpp"
#include "hil/program/options.hpp"
#include "hil/program/part_arguments.hpp"
#include "hil/track/track.hpp"

namespace drydock::program {

/// What is read: the same for every command that makes a track.
struct DiveArguments {
  std::vector<std::string> files;
  PartArguments part;

  void add_files(CLI::App& sub) {
    sub.add_option("RECORDING", files,
                   "MCAP recording, or capture of one sensor; with --rig several captures, where "
                   "NAME=FILE names the device that reads it")
        ->required();
  }
  void add_rig_and_part(CLI::App& sub, std::string& rig) {
    sub.add_option("--rig", rig,
                   "rig file in the place of the recorded one, or with the sensors of the captures")
        ->transform(rig_name);
    part.add_only_and_from(sub);
    part.add_to(sub);
  }
  /// In the callback of the command: what does not fit together is a CLI::ParseError.
  void read(track::TrackOptions& options) const {
    options.part = part.selection();
    options.source.capture = files.front();
    const auto first = named_file(files.front());
    if (files.size() == 1 && first.device.empty()) return;
    if (options.rig.empty())
      throw CLI::RequiredError("--rig, whose devices read several captures,");
    if (!options.source.protocol.empty())
      throw CLI::ValidationError("--protocol", "the rig file says what its sensors speak");
    for (const auto& text : files) options.captures.push_back(named_file(text));
  }
  /// When the command runs.
  void open(track::TrackOptions& options) const {
    if (options.captures.empty()) must_be_readable(options.source.capture);
    for (const auto& file : options.captures) must_be_capture(file.path);
    options.source.description = load_protocol(options.source.protocol);
  }
};

}  // namespace drydock::program

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
    sub.add_option(
           "RECORDING", files,
           "MCAP recording, or capture of one sensor, or several that it made one after the "
           "other, or their folder; with --rig of several sensors, where NAME=FILE or "
           "NAME=FOLDER names the device that reads it")
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
  void read(track::DiveSource& dive) const {
    dive.part = part.selection();
    for (const auto& text : files)
      for (auto& file : named_files(text)) dive.captures.push_back(std::move(file));
    const auto& first = dive.captures.front();
    dive.source.capture = first.path;
    if (dive.captures.size() == 1 && first.device.empty()) {
      dive.captures.clear();
    } else if (dive.rig.empty() && (dive.source.protocol.empty() || !first.device.empty())) {
      throw CLI::RequiredError(
          "--rig, whose devices read several captures, or --protocol of the one sensor of all,");
    } else if (!dive.rig.empty() && !dive.source.protocol.empty()) {
      throw CLI::ValidationError("--protocol", "the rig file says what its sensors speak");
    }
  }
  /// When the command runs.
  void open(track::DiveSource& dive) const {
    if (dive.captures.empty()) must_be_readable(dive.source.capture);
    for (const auto& file : dive.captures) must_be_capture(file);
    dive.source.description = load_protocol(dive.source.protocol);
  }
};

}  // namespace drydock::program

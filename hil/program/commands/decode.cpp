#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "drivers/decode/decode.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/look_of_capture.hpp"
#include "hil/replay/replay_rig.hpp"
#include "rig_config/nearest_file.hpp"

namespace drydock::program {
namespace {

/// Throws std::runtime_error with what to do.
void must_be_decodable(const std::string& file) {
  if (replay::is_recording(file))
    throw std::runtime_error(file +
                             " is a recording of a rig: drydock replay and drydock topic read "
                             "it, drydock export --to raw gives the bytes of its lines");
  must_be_no_foreign_file(file);
}

/// The name of a protocol in the place of a file.
void must_be_no_protocol(const std::string& file) {
  std::error_code error;
  if (std::filesystem::exists(file, error)) return;
  std::istringstream names(decode::decode_protocols());
  for (std::string name; std::getline(names >> std::ws, name, ',');)
    if (name == file)
      throw CLI::ValidationError(
          "FILE", fmt::format("{} is a protocol and no file: --protocol {}", file, file));
}

/// Of several files: before the first one is decoded.
void must_exist(const std::string& file) {
  std::error_code error;
  if (file != "-" && !std::filesystem::exists(file, error))
    throw std::runtime_error(
        fmt::format("{}: {}{}", file, std::strerror(ENOENT), rig_config::nearest_file(file)));
}

}  // namespace

void add_decode(CLI::App& app, Command& command) {
  auto options = std::make_shared<decode::DecodeOptions>();
  auto files = std::make_shared<std::vector<std::string>>();
  auto* sub =
      app.add_subcommand("decode", "Turn a recording into JSON Lines, one object a message");
  sub->footer(
      "Example: drydock decode --protocol pd0 dive.pd0\n"
      "         drydock decode --protocol pd0 dive-1.pd0 dive-2.pd0 dive-3.pd0\n"
      "         drydock decode --protocol can trace.asc\n"
      "         drydock decode --dbc imu.dbc can.log\n"
      "         drydock decode --pgns canboat.json can.log\n"
      "         candump -L can0 | drydock decode --protocol nmea2000");
  sub->add_option("FILE", *files,
                  "recording, or the files of one in their order; default standard input");
  auto* protocol = sub->add_option(
      "--protocol", options->protocol,
      "one of " + decode::decode_protocols() + "; or a description: valeport-vat.toml");
  auto* dbc = sub->add_option("--dbc", options->dbc,
                              "a DBC file that describes the messages of a CAN capture");
  dbc->excludes(protocol);
  sub->add_option("--pgns", options->pgns,
                  "a table of PGNs (canboat.json) for an NMEA 2000 capture")
      ->excludes(protocol)
      ->excludes(dbc);
  sub->add_option(
      "--format", options->format,
      "the file's format, where its content does not tell: one of " + decode::decode_formats());
  sub->add_option("--interface", options->interface,
                  "of a file of packets with several lines; default the only one that speaks");
  sub->add_flag("--count", options->count, "how many of each type, not the messages");
  sub->add_flag("--quiet", options->quiet, "no line of counts at the end");
  sub->callback([options, files, &command] {
    for (const auto& file : *files) must_be_no_protocol(file);
    command = [options, files] {
      for (const auto& file : *files) {
        if (files->size() > 1) must_exist(file);
        must_be_decodable(file);
      }
      if (!files->empty()) {
        options->file = files->front();
        options->more.assign(files->begin() + 1, files->end());
      }
      options->description = load_protocol(options->protocol);
      const int code = decode::decode(*options, stdout, stderr);
      if (code == terminal::exit_failed) say_what_it_looks_like(options->file, options->protocol);
      return code;
    };
  });
}

}  // namespace drydock::program

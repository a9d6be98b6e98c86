#include <fmt/format.h>

#include <memory>

#include "drivers/probe/describe.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/printable.hpp"
#include "drivers/wire/dbc/writer.hpp"
#include "drivers/wire/described/frame_plan.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "rig_config/device_description/description_page.hpp"

namespace drydock::program {
namespace {

struct DescribeOptions {
  std::string file;
  bool dbc = false, page = false;
};

/// The messages that a description of frames uses, as a DBC file.
std::string dbc_of(const wire::described::FramePlan& frames) {
  std::vector<wire::dbc::Message> messages;
  for (const auto& frame : frames.frames) messages.push_back(frame.message);
  return wire::dbc::write(messages);
}

int refuse(const std::string& file, std::string_view why) {
  fmt::print(stderr, "describe: {} {}\n", text::printable(file), why);
  return terminal::exit_usage;
}

int describe(const DescribeOptions& options) {
  if (!options.dbc && !options.page) return probe::describe(options.file, stdout, stderr);
  const auto description = load_protocol(options.file);
  if (!description)
    return refuse(options.file,
                  "is no description; allowed: the file of one (*.toml), or the name of one that "
                  "comes with the program");
  if (options.dbc && !description->frames)
    return refuse(options.file, "describes bytes; allowed: a description of CAN frames");
  fmt::print("{}", options.dbc ? dbc_of(*description->frames)
                               : rig_config::description_page(*description));
  return terminal::exit_success;
}

}  // namespace

void add_describe(CLI::App& app, Command& command) {
  auto options = std::make_shared<DescribeOptions>();
  auto* sub = app.add_subcommand(
      "describe", "Guess a first description of an unknown sensor from a capture of its bytes");
  sub->footer(
      "Example: drydock describe unknown.bin > sensor.toml\n"
      "         drydock describe --page valeport-vat.toml > sensor.md\n"
      "         drydock describe --dbc xsens-dbc.toml > sensor.dbc");
  sub->add_option("CAPTURE", options->file,
                  "bytes as the line carried them; with --dbc or --page a description")
      ->required();
  auto* dbc = sub->add_flag("--dbc", options->dbc,
                            "of a description of CAN frames, the DBC file of its messages");
  sub->add_flag("--page", options->page, "of a description, a page in Markdown about the sensor")
      ->excludes(dbc);
  sub->callback([options, &command] { command = [options] { return describe(*options); }; });
}

}  // namespace drydock::program

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "drivers/recordings/tasks/recordings.hpp"
#include "drivers/terminal/duration.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/part_arguments.hpp"
#include "hil/replay/recording_progress.hpp"

namespace drydock::program {

namespace {

struct ExportArguments {
  PartArguments part;
  std::vector<std::string> to;
  recordings::ExportOptions options;
};

/// `--to pcapng --to 25s`: one word is the format, the other is the end of the part.
void read_to(ExportArguments& a) {
  bool has_format = false;
  for (const auto& word : a.to) {
    if (const auto seconds = terminal::parse_duration(word)) {
      a.part.to_s = *seconds;
      continue;
    }
    const auto* format = std::ranges::find(exporting::formats, word, &exporting::FormatEntry::name);
    if (format == exporting::formats.end())
      throw CLI::ValidationError(
          "--to", fmt::format("'{}' is no format; allowed: candump, pcapng, raw, csv, nmea", word));
    a.options.format = format->format;
    has_format = true;
  }
  if (!has_format) throw CLI::RequiredError("--to candump|pcapng|raw|csv|nmea");
}

}  // namespace

void add_export(CLI::App& app, Command& command) {
  auto a = std::make_shared<ExportArguments>();
  auto* sub = app.add_subcommand("export", "A recording in the format of another program");
  sub->footer(
      "Example: drydock export dive.mcap --to pcapng && wireshark dive.pcapng\n"
      "         drydock export dive.mcap --to csv -o tables --only dvl,imu --from 10s --to 25s");
  sub->add_option("RECORDING", a->options.recording, "recording (MCAP)")->required();
  sub->add_option(
         "--to", a->to,
         "one of candump, pcapng, raw, csv, nmea; given again, a time: the end of the part")
      ->required()
      ->allow_extra_args(false)
      ->take_all();
  sub->add_option(
      "-o,--output", a->options.target.path,
      "file (candump, pcapng, nmea; - is standard output) or folder (raw, csv); default "
      "the recording's name, here");
  sub->add_flag("--overwrite", a->options.target.overwrite, "replace what is there");
  sub->add_flag("--plain", a->options.target.plain, "nmea: sentences without times before them");
  sub->add_flag("--direction", a->options.target.direction,
                "candump: R (received) or T (sent) behind each frame, as candump -x");
  a->part.add_only_and_from(*sub);
  sub->callback([a, &command] {
    read_to(*a);
    command = [a] {
      replay::RecordingProgress progress("export", stderr);
      a->options.part = a->part.selection();
      return recordings::export_recording(a->options, std::ref(progress), stderr);
    };
  });
}

}  // namespace drydock::program

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "drivers/measurement/units.hpp"
#include "drivers/recordings/tasks/recordings.hpp"
#include "drivers/terminal/duration.hpp"
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

void add_export(CLI::App& app, Command& command) {
  auto a = std::make_shared<ExportArguments>();
  auto* sub = app.add_subcommand("export", "A recording in the format of another program");
  sub->footer(
      "Example: drydock export dive.mcap --to pcapng && wireshark dive.pcapng\n"
      "         drydock export dive.mcap --to csv -o tables --only dvl,imu --from 10s --to 25s");
  sub->add_option("RECORDING", a->options.recording, "recording (MCAP)")->required();
  sub->add_option("--to", a->to,
                  "candump, pcapng, raw, csv or nmea; given again, a time: the end of the part")
      ->required()
      ->allow_extra_args(false)
      ->take_all();
  sub->add_option(
      "-o,--output", a->options.target.path,
      "file (candump, pcapng, nmea; - is standard output) or folder (raw, csv); default "
      "the recording's name, here");
  sub->add_flag("--overwrite", a->options.target.overwrite, "replace what is there");
  sub->add_flag("--plain", a->options.target.plain, "nmea: sentences without times before them");
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

void add_recover(CLI::App& app, Command& command) {
  auto options = std::make_shared<recordings::RecoverOptions>();
  auto* sub = app.add_subcommand("recover", "Make a cut or damaged recording whole again");
  sub->footer("Example: drydock recover dive.mcap -o dive-whole.mcap");
  sub->add_option("RECORDING", options->recording, "recording (MCAP), of whatever program")
      ->required();
  sub->add_option("-o,--output", options->output, "default NAME-recovered.mcap, here");
  sub->add_flag("--overwrite", options->overwrite, "replace what is there");
  sub->callback([options, &command] {
    command = [options] { return recordings::recover(*options, stderr); };
  });
}

struct CutArguments {
  PartArguments part;
  std::optional<double> shift_s;
  std::string start_at;
  bool move = false;
  std::vector<double> place_deg{0, -30};  ///< in the open Atlantic
  recordings::CutOptions options;
};

void add_privacy(CLI::App& sub, CutArguments& a) {
  auto* shift =
      sub.add_option("--shift-time", a.shift_s, "earlier by so much: 90, 60s, 10min, 5.5h")
          ->transform(duration_text);
  sub.add_option("--start-at", a.start_at, "or so that the slice starts then: 2020-01-01T00:00:00Z")
      ->excludes(shift);
  auto* move = sub.add_flag(
      "--shift-position", a.move,
      "move every position, in raw bytes too; drop what tells the place and cannot be moved");
  sub.add_option("--place", a.place_deg, "where the first position goes, latitude,longitude [deg]")
      ->delimiter(',')
      ->expected(2)
      ->capture_default_str()
      ->needs(move);
}

void read_privacy(CutArguments& a) {
  auto& slice = a.options.slice;
  if (a.shift_s) slice.shift_time = -measurement::from_seconds(*a.shift_s);
  if (!a.start_at.empty()) {
    slice.start_at = recordings::parse_utc(a.start_at);
    if (!slice.start_at)
      throw CLI::ValidationError("--start-at",
                                 "'" + a.start_at + "' is no time; allowed: 2020-01-01T00:00:00Z");
  }
  if (std::abs(a.place_deg[0]) > 89 || std::abs(a.place_deg[1]) > 180)
    throw CLI::ValidationError("--place", "allowed: -89 to 89, -180 to 180");
  if (a.move) slice.move_to = {a.place_deg[0] * units::degree, a.place_deg[1] * units::degree};
}

void add_cut(CLI::App& app, Command& command) {
  auto a = std::make_shared<CutArguments>();
  auto* sub = app.add_subcommand("cut", "A part of a recording, to keep, to send or to test with");
  sub->footer(
      "Example: drydock cut dive.mcap -o slice.mcap --from 10s --to 25s --only dvl\n"
      "         drydock cut dive.mcap --start-at 2020-01-01T00:00:00Z --shift-position\n"
      "         drydock cut dive.mcap --from 10s --to 25s --as-fixture lost-bottom-lock");
  sub->add_option("RECORDING", a->options.recording, "recording (MCAP)")->required();
  auto* output = sub->add_option("-o,--output", a->options.output, "default NAME-cut.mcap, here");
  sub->add_flag("--overwrite", a->options.slice.overwrite, "replace what is there");
  sub->add_option("--as-fixture", a->options.fixture,
                  "make it a regression test, fixtures/dives/NAME, with what its drivers measure")
      ->excludes(output);
  a->part.add_only_and_from(*sub);
  a->part.add_to(*sub);
  add_privacy(*sub, *a);
  sub->callback([a, &command] {
    read_privacy(*a);
    command = [a] {
      replay::RecordingProgress progress("cut", stderr);
      a->options.slice.part = a->part.selection();
      return recordings::cut(a->options, std::ref(progress), stderr);
    };
  });
}

void add_bisect(CLI::App& app, Command& command) {
  auto options = std::make_shared<recordings::BisectOptions>();
  auto* sub = app.add_subcommand("bisect", "The smallest part of a recording that still fails");
  sub->footer(
      "Example: drydock bisect dive.mcap --run './my_navigation --input {}' -o smallest.mcap");
  sub->add_option("RECORDING", options->recording, "recording (MCAP)")->required();
  sub->add_option("--run", options->command,
                  "for the shell, {} is the part; an exit code other than 0 is the failure")
      ->required();
  sub->add_option("-o,--output", options->output, "default NAME-smallest.mcap, here");
  sub->add_flag("--overwrite", options->overwrite, "replace what is there");
  sub->callback([options, &command] {
    command = [options] {
      replay::RecordingProgress progress("bisect", stderr);
      return recordings::bisect(*options, std::ref(progress), stderr);
    };
  });
}

}  // namespace

void add_recording_commands(CLI::App& app, Command& command) {
  add_export(app, command);
  add_recover(app, command);
  add_cut(app, command);
  add_bisect(app, command);
}

}  // namespace drydock::program

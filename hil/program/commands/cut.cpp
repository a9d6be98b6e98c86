#include <cmath>
#include <memory>

#include "drivers/measurement/units.hpp"
#include "drivers/recordings/tasks/recordings.hpp"
#include "drivers/text/utc.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/options.hpp"
#include "hil/program/part_arguments.hpp"
#include "hil/replay/recording_progress.hpp"

namespace drydock::program {

namespace {

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
    slice.start_at = text::parse_utc(a.start_at);
    if (!slice.start_at)
      throw CLI::ValidationError("--start-at",
                                 "'" + a.start_at + "' is no time; allowed: 2020-01-01T00:00:00Z");
  }
  if (std::abs(a.place_deg[0]) > 89 || std::abs(a.place_deg[1]) > 180)
    throw CLI::ValidationError("--place", "allowed: -89 to 89, -180 to 180");
  if (a.move) slice.move_to = {a.place_deg[0] * units::degree, a.place_deg[1] * units::degree};
}

}  // namespace

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

}  // namespace drydock::program

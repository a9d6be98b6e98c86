#include "hil/track/track.hpp"

#include <memory>

#include "hil/program/commands.hpp"
#include "hil/program/dive_arguments.hpp"
#include "hil/program/start_argument.hpp"

namespace drydock::program {

namespace {

struct TrackArguments {
  track::TrackOptions options;
  DiveArguments dive;
  std::string model = "best";
};

void finish(TrackArguments& a) {
  auto& o = a.options;
  a.dive.read(o);
  if (a.model == "inertial") o.model = track::Model::inertial;
  if (a.model == "level") o.model = track::Model::level;
}

}  // namespace

void add_track(CLI::App& app, Command& command) {
  auto a = std::make_shared<TrackArguments>();
  auto& o = a->options;
  auto* sub = app.add_subcommand(
      "track", "The best track of a dive after the fact, with its uncertainty and residuals");
  sub->footer(
      "Example: drydock track dive.mcap -o dive.geojson --report out\n"
      "         drydock track dive.mcap --model level --json\n"
      "         drydock track dvl=dive.pd0 can.asc --rig my-rig.toml -o dive.csv\n"
      "         drydock track dive.pd0 --protocol pd0 --start 41.5,-70.7 -o dive.gpx");
  a->dive.add_files(*sub);
  sub->add_option("-o,--out", o.out, "file of the track");
  sub->add_option("--as", o.as,
                  "its format, one of geojson, gpx, csv, mcap; default as its name ends")
      ->check(CLI::IsMember({"geojson", "gpx", "csv", "mcap"}));
  sub->add_option("--every", o.every_s,
                  "time between points of GeoJSON, GPX and CSV; default 1s, 0: every epoch")
      ->transform(duration_text);
  sub->add_flag("--overwrite", o.overwrite, "replace what is there");
  sub->add_option("--report", o.report, "write index.html with a map into this folder");
  sub->add_flag("--json", o.json, "one JSON object instead of text");
  sub->add_option("--model", a->model,
                  "inertial: the IMU with the grade of the rig's estimator; level: without it; "
                  "default best: inertial where that is possible")
      ->check(CLI::IsMember({"best", "inertial", "level"}));
  add_start(*sub, o.origin);
  a->dive.add_rig_and_part(*sub, o.rig);
  add_capture(*sub, o.source);
  sub->callback([a, &command] {
    finish(*a);
    command = [a] {
      a->dive.open(a->options);
      return track::track(a->options, stdout, stderr);
    };
  });
}

}  // namespace drydock::program

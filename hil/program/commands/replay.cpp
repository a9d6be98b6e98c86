#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <memory>

#include "drivers/decode/replay.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "hil/program/capture_arguments.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/look_of_capture.hpp"
#include "hil/program/named_file.hpp"
#include "hil/program/options.hpp"
#include "hil/program/part_arguments.hpp"
#include "hil/replay/capture_report.hpp"
#include "hil/replay/replay_rig.hpp"
#include "hil/summary/write_files.hpp"

namespace drydock::program {

namespace {

struct ReplayArguments {
  std::vector<std::string> files;  ///< one recording, or captures, with a rig also NAME=FILE
  decode::ReplayOptions capture;
  replay::RigReplayOptions recording;
  PartArguments part;
  std::string speed;
};

void add_recording_options(CLI::App& sub, ReplayArguments& a) {
  auto& r = a.recording;
  a.part.add_only_and_from(sub);
  a.part.add_to(sub);
  sub.add_option(
         "--rig", r.rig,
         "another rig file: its drivers and estimators get the bytes of the devices with the "
         "same names, or those of captures; default the recorded rig")
      ->transform(rig_name);
  sub.add_option("--report", r.report, "write a page with figures and plots into this folder");
  sub.add_option("--json", r.json, "write the summary to this file");
  sub.add_option("--junit", r.junit, "write the verdicts on [[expect]] to this file");
  sub.add_flag("--expect", r.expect, "judge the rig's [[expect]]; exit 1 where one is not met");
  sub.add_option(
      "--faults", r.faults,
      "file of blocks [[fault]] that come between recording and drivers: docs/use/faults.md");
  sub.add_flag("--step", r.step, "wait for Enter behind each message; q ends");
  auto* record = sub.add_option("--record", r.record.path, "record the replay to this MCAP file");
  sub.add_flag("--overwrite", r.record.overwrite, "replace what is there")->needs(record);
  auto* check = sub.add_option("--check", r.check,
                               "compare with this reference; exit 1 and the first divergence where "
                               "something else comes out");
  sub.add_option("--tolerance", r.tolerance, "of --check, relative; default 0: every byte counts")
      ->needs(check)
      ->check(CLI::NonNegativeNumber);
  auto* update =
      sub.add_option("--update-refs", r.update_refs, "write the reference")->excludes(check);
  sub.add_option("--refs-every", r.refs_every,
                 "values of each so many messages; default all, thinned to 2000 a topic")
      ->needs(update)
      ->check(positive_number);
  sub.add_option("--onto", r.onto,
                 "give other programs what the links carried: dvl=pty:dvl, can0=socketcan:vcan0, "
                 "again for each; or auto for all links; speed 1 unless given")
      ->allow_extra_args(false)
      ->take_all();
  add_serve(sub, r.serve, "; speed 1 unless given");
}

/// The value 0 means as fast as possible. The result is empty if the text is no speed.
std::optional<double> speed_of(const std::string& text) {
  if (text == "max") return 0;
  double speed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), speed);
  if (error != std::errc{} || end != text.data() + text.size() || !(speed > 0)) return {};
  return speed;
}

/// The options of all that a whole rig plays.
void read_for_rig(ReplayArguments& a) {
  auto& r = a.recording;
  if (!a.capture.protocol.empty())
    throw CLI::ValidationError("--protocol", "the rig file says what its sensors speak");
  const bool shared = !r.onto.empty() || !r.serve.address.empty();
  if (a.speed.empty()) a.speed = shared ? "1" : "max";
  const auto speed = speed_of(a.speed);
  if (!speed) throw CLI::ValidationError("--speed", "allowed: max, 1, or another factor");
  if (shared && *speed == 0)
    throw CLI::ValidationError("--speed", "max is virtual time: not with --onto and --serve");
  if (r.step && *speed > 0)
    throw CLI::ValidationError("--step", "not with --speed, --onto, --serve");
  if (r.step && r.quiet) throw CLI::ValidationError("--step", "shows messages: not with --quiet");
  const bool judged = r.expect || !r.report.empty() || !r.json.empty() || !r.junit.empty();
  if (judged && !a.part.selection().only.empty())
    throw CLI::ValidationError("--only", "not with --report, --json, --junit, --expect");
  r.speed = *speed;
  r.part = a.part.selection();
}

/// Captures that the devices of a rig read.
void read_captures_for_rig(const CLI::App& sub, ReplayArguments& a) {
  for (const char* option : {"--kind", "--address"})
    if (sub.count(option) > 0)
      throw CLI::ValidationError(option, "the rig file says it of each of its devices");
  read_for_rig(a);
  auto& captures = a.recording.captures;
  captures.how = a.capture;
  for (const auto& text : a.files) {
    for (auto& file : named_files(text)) {
      must_be_capture(file);
      captures.files.push_back(std::move(file));
    }
  }
  a.recording.recording = fmt::format("{}", fmt::join(a.files, ", "));
}

/// By its name and for want of a protocol: reading it then says what is wrong with it.
bool says_recording(const decode::ReplayOptions& capture) {
  return capture.protocol.empty() && capture.capture.ends_with(".mcap");
}

/// A capture has no rig: it uses one driver and refuses the options that need a whole rig.
void read_capture(const CLI::App& sub, ReplayArguments& a) {
  must_be_readable(a.capture.capture);
  if (a.files.size() > 1) throw CLI::RequiredError("--rig, whose devices read several captures,");
  if (a.capture.protocol.empty())
    throw CLI::RequiredError("--protocol, or --rig (" + a.capture.capture +
                             " is no MCAP recording)");
  for (const char* option :
       {"--only", "--from", "--to", "--faults", "--step", "--record", "--check", "--update-refs",
        "--onto", "--serve", "--junit", "--expect"})
    if (sub.count(option) > 0)
      throw CLI::ValidationError(option, "needs an MCAP recording, or --rig with a capture");
  if (!a.speed.empty()) a.capture.speed = a.speed;
}

void write_summary(const ReplayArguments& a) {
  const summary::SummaryFiles files{a.recording.json, a.recording.report, ""};
  if (files.json.empty() && files.report.empty()) return;
  const auto made = replay::summary_of_capture(a.capture);
  if (!a.capture.quiet) fmt::print(stderr, "{}", to_text(made));
  summary::write_files(made, files, "");
}

}  // namespace

void add_replay(CLI::App& app, Command& command) {
  auto a = std::make_shared<ReplayArguments>();
  auto* sub = app.add_subcommand(
      "replay",
      "Play a recording through its rig's drivers and estimators, or captures through those of "
      "a rig or one capture through one driver: JSON Lines");
  sub->footer(
      "Example: drydock replay dive.mcap --only dvl,imu --from 10s --to 25s\n"
      "         drydock replay dive.mcap --quiet --update-refs refs.json\n"
      "         drydock replay dive.mcap --quiet --check refs.json\n"
      "         drydock replay dive.mcap --onto dvl=pty:dvl --speed 1\n"
      "         drydock replay dive.mcap --faults F.toml\n"
      "         drydock replay dive.mcap --rig other.toml --quiet --report out --expect\n"
      "         drydock replay can.asc dvl=dive.pd0 --rig my-rig.toml --quiet --report out\n"
      "         drydock replay dive.pd0 --protocol pd0\n"
      "         drydock replay dive.pd0 --protocol pd0 --report out > dive.jsonl");
  sub->add_option("RECORDING", a->files,
                  "MCAP recording, or capture of one link; with --rig several captures, where "
                  "NAME=FILE names the device that reads it")
      ->required();
  sub->add_option("--speed", a->speed,
                  "max: at once, in virtual time (default); 1: at the recording's own pace; or a "
                  "factor");
  sub->add_flag("--quiet", a->capture.quiet,
                "of a recording the summary alone; of a capture no states and totals");
  add_recording_options(*sub, *a);
  add_capture(*sub, a->capture);
  sub->callback([a, sub, &command] {
    a->recording.quiet = a->capture.quiet;
    a->recording.recording = a->capture.capture = a->files.front();
    const bool is_recording = a->files.size() == 1 && (replay::is_recording(a->capture.capture) ||
                                                       says_recording(a->capture));
    if (is_recording || !a->recording.rig.empty()) {
      is_recording ? read_for_rig(*a) : read_captures_for_rig(*sub, *a);
      command = [a] { return replay::replay_rig(a->recording, stdin, stdout, stderr); };
      return;
    }
    read_capture(*sub, *a);
    command = [a] {
      a->capture.description = load_protocol(a->capture.protocol);
      const int code = decode::replay(a->capture, stdout, stderr);
      write_summary(*a);
      if (code == terminal::exit_failed)
        say_what_it_looks_like(a->capture.capture, a->capture.protocol);
      return code;
    };
  });
}

}  // namespace drydock::program

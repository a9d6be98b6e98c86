#include "hil/replay/replay_rig.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "drivers/host/finding_lines.hpp"
#include "drivers/host/finding_log.hpp"
#include "drivers/host/state_lines.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "estimators/host/diagnostician_beside.hpp"
#include "estimators/host/sound_devices.hpp"
#include "estimators/setup/rig_pipeline.hpp"
#include "hil/replay/other_programs.hpp"
#include "hil/replay/recording_progress.hpp"
#include "hil/replay/reference_outlets.hpp"
#include "hil/replay/replay_account.hpp"
#include "hil/replay/replay_bench.hpp"
#include "hil/replay/replay_lines.hpp"
#include "hil/replay/replay_source.hpp"
#include "hil/replay/replay_summary.hpp"
#include "hil/replay/rigs/other_rig.hpp"
#include "hil/replay/rigs/recorded_rig.hpp"
#include "hil/summary/findings.hpp"
#include "hil/summary/judge.hpp"
#include "hil/summary/write_files.hpp"
#include "rig_config/load.hpp"

namespace drydock::replay {

namespace {

using Faults = std::vector<rig_config::FaultConfig>;

Faults faults_of(const std::string& path) {
  return path.empty() ? Faults{} : rig_config::load_faults(path).value();
}

/// One replay with all outputs of its options. Members are in the order in which they need each
/// other.
class RigReplay {
 public:
  RigReplay(const RigReplayOptions& options, ReplaySource source, std::FILE* in, std::FILE* out,
            std::FILE* err)
      : options_(options),
        out_(out),
        err_(err),
        recording_(std::move(source.recording)),
        recorded_(recording_),
        other_(source.laid ? std::move(*source.laid) : rig_to_play()),
        faults_(faults_of(options.faults)),
        references_(options, faults_),
        lines_(rig(), out),
        steps_(in) {
    if (const auto wrong = misfit(options.part, recording_); !wrong.empty())
      throw std::runtime_error(wrong);
    for (const auto& estimator : rig().estimators)
      if (std::ranges::find(options.part.only, estimator.name) != options.part.only.end())
        throw std::runtime_error("--only: " + estimator.name +
                                 " is an estimator; name the devices that feed it");
    // The rig in a recording comes from somebody else, and starts no program here.
    if (!options.rig.empty())
      outside_ =
          programs_of(rig(), [this](const std::string& line) { fmt::print(err_, "{}\n", line); });
    if (!options.onto.empty()) onto_.emplace(io_, recording_.links(), options.onto);
    bench_.emplace(recording_, rig(), options_.part,
                   ReplayOutlets{step(), onto_ ? &*onto_ : nullptr,
                                 [this] {
                                   if (summary_) summary_->note_end();
                                 },
                                 outside_ ? &*outside_ : nullptr, std::move(source.ends)},
                   faults_);
    add_followers();
    if (options.rig.empty() && !recorded_.trouble().empty())
      fmt::print(err_, "{}\n", recorded_.trouble());
    for (const auto& note : other_.notes) fmt::print(err_, "{}\n", note);
    for (const auto& line : onto_ ? onto_->lines() : std::vector<std::string>{})
      fmt::print(err_, "onto {}\n", line);
    if (viewer_) fmt::print(err_, "live: {}\n", viewer_->url());
    std::fflush(err_);
  }

  int run() {
    Pace pace(io_, options_.speed);
    if (draws_over_lines()) {
      bench_->play(pace, [](double) { return true; });
    } else {
      RecordingProgress progress("replay", err_, [this] {
        return host::RunStanding{
            .recorded = recorder_ ? std::optional(recorder_->bytes()) : std::nullopt,
            .rates_hz = bench_->rates_hz()};
      });
      bench_->play(pace, std::ref(progress));
    }
    close_outlets();
    if (!lines_.flush()) return cannot_write();
    print_summary(options_.quiet ? out_ : err_);
    const bool as_before = references_.finish(!bench_->interrupted(), err_);
    const bool sound = judged() && as_before;
    const bool recorded = !(recorder_ && recorder_->failed());
    return terminal::exit_of(sound && recorded && bench_->measurements() > 0);
  }

 private:
  using Stamp = measurement::Stamp;

  const rig_config::Rig& rig() const { return other_.rig; }

  OtherRig rig_to_play() const {
    if (options_.rig.empty()) return {recorded_.rig(), {}};
    return fit(rig_in(options_.rig), recording_, recorded_.rig());
  }

  /// Captures have none.
  std::unique_ptr<RecordedTrajectory> recorded_truth() const {
    return options_.captures.files.empty() ? RecordedTrajectory::read(options_.recording) : nullptr;
  }

  bool is_judged() const {
    return options_.expect || !options_.report.empty() || !options_.json.empty() ||
           !options_.junit.empty();
  }

  /// Returns false if an expectation was not met, or another program did not answer well.
  bool judged() {
    if (!summary_) {
      const auto verdicts = verdicts_on_programs(rig(), bench_->pipeline());
      fmt::print(options_.quiet ? out_ : err_, "{}", summary::to_text(verdicts));
      return std::ranges::all_of(verdicts, &summary::Verdict::passed);
    }
    auto made = summary_->made();
    if (auto verdict = verdict_on(recording_)) made.verdicts.push_back(std::move(*verdict));
    made.findings = summary::accounts_of(findings_, rig(), bench_->start());
    fmt::print(options_.quiet ? out_ : err_, "{}", to_text(made));
    std::ranges::copy(other_.notes, std::back_inserter(made.notes));  // they were said at the start
    summary::write_files(made, {options_.json, options_.report, options_.junit}, rig().file);
    return std::ranges::all_of(made.verdicts, &summary::Verdict::passed);
  }

  int cannot_write() {
    fmt::print(err_, "replay: cannot write the output\n");
    return terminal::exit_failed;
  }

  /// True if a progress bar would overwrite the lines, because both go to the same terminal.
  bool draws_over_lines() const { return !options_.quiet && ::isatty(fileno(out_)) == 1; }

  void close_outlets() {
    io_.restart();
    io_.poll();  // sends what was queued last
    if (onto_) onto_->close();
    if (viewer_) viewer_->stop();
    io_.restart();
    io_.run();
  }

  /// When the user steps, each line is shown at once, and then the next step is awaited.
  std::function<bool(const terminal::InterruptFlag&)> step() {
    if (!options_.step || options_.quiet) return {};
    return [this](const terminal::InterruptFlag& interrupt) {
      lines_.flush();
      return steps_.next(interrupt);
    };
  }

  void add_followers() {
    const auto& rig = this->rig();
    auto& followers = bench_->followers();
    diagnostician_ = host::diagnostician_beside(rig, bench_->devices(), followers);
    followers.add(*diagnostician_);
    followers.add(sound_devices_.emplace(rig, bench_->pipeline()));
    followers.add(findings_);
    references_.follow(followers, rig);
    if (is_judged()) summary_.emplace(rig, *bench_, options_.recording, recorded_truth());
    if (!options_.record.path.empty())
      followers.add(recorder_.emplace(
          rig, options_.record, recording_.begin().value_or(Stamp{}),
          options_.speed > 0 ? record::WhenBehind::lose : record::WhenBehind::wait));
    if (!options_.serve.address.empty())
      followers.add(viewer_.emplace(io_.get_executor(), rig, options_.serve));
    if (options_.quiet) return;
    followers.add(lines_);
    followers.add(states_.emplace(err_, bench_->start()));
    followers.add(said_.emplace(
        rig, bench_->start(), [this](const std::string& line) { fmt::print(err_, "{}\n", line); }));
  }

  void print_summary(std::FILE* to) {
    const auto& rig = this->rig();
    print_account(to, rig, *bench_);
    if (!summary_) {  // which says them too
      fmt::print(to, "{}",
                 summary::findings_text(summary::accounts_of(findings_, rig, bench_->start())));
      for (const auto& note : setup::pipeline_notes(rig, bench_->pipeline()))
        fmt::print(to, "{}\n", note);
    }
    if (recorder_) fmt::print(to, "{}\n", recorder_->finish());
    if (onto_ && onto_->lost() > 0)
      fmt::print(to, "onto: {} reads or frames were not taken by the other side\n", onto_->lost());
    if (const auto note = recording_.clock_note(); !note.empty()) fmt::print(to, "{}\n", note);
    if (!recording_.damage().empty())
      fmt::print(to, "the recording is damaged: {} (drydock recover)\n", recording_.damage());
    print_length(to, options_.part, *bench_);
  }

  const RigReplayOptions& options_;
  std::FILE *out_, *err_;
  boost::asio::io_context io_{1};
  record::Recording recording_;
  RecordedRig recorded_;
  OtherRig other_;  ///< the recorded one, if no other is asked for
  Faults faults_;
  ReferenceOutlets references_;
  ReplayLines lines_;
  std::shared_ptr<host::Follower> diagnostician_;
  std::optional<host::SoundDevices> sound_devices_;
  host::FindingLog findings_;
  std::optional<host::FindingLines> said_;
  std::optional<host::StateLines> states_;
  Steps steps_;
  std::optional<Onto> onto_;
  std::optional<host::RigRecorder> recorder_;
  std::optional<host::RigViewer> viewer_;
  std::optional<setup::Outside> outside_;  ///< empty: no other program is asked
  std::optional<ReplayBench> bench_;
  std::optional<ReplaySummary> summary_;
};

}  // namespace

int replay_rig(const RigReplayOptions& options, std::FILE* in, std::FILE* out, std::FILE* err) {
  const auto refused = [&](const std::exception& error, int code) {
    fmt::print(err, "replay: {}\n", error.what());
    return code;
  };
  std::optional<ReplaySource> source;
  try {
    source = source_of(options);
  } catch (const std::exception& error) {
    return refused(error,
                   options.captures.files.empty() ? terminal::exit_failed : terminal::exit_usage);
  }
  std::optional<RigReplay> replay;
  try {
    replay.emplace(options, std::move(*source), in, out, err);
  } catch (const std::exception& error) {
    return refused(error, terminal::exit_usage);
  }
  try {
    return replay->run();
  } catch (const std::exception& error) {  // an output cannot be written
    return refused(error, terminal::exit_failed);
  }
}

}  // namespace drydock::replay

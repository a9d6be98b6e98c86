#include "hil/replay/replay_rig.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
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
#include "hil/replay/other_rig.hpp"
#include "hil/replay/recorded_rig.hpp"
#include "hil/replay/recording_progress.hpp"
#include "hil/replay/reference_check.hpp"
#include "hil/replay/replay_account.hpp"
#include "hil/replay/replay_bench.hpp"
#include "hil/replay/replay_lines.hpp"
#include "hil/replay/replay_summary.hpp"
#include "hil/replay/topics_follower.hpp"
#include "hil/report/write_file.hpp"
#include "hil/summary/findings.hpp"
#include "hil/summary/judge.hpp"
#include "hil/summary/write_files.hpp"
#include "rig_config/load.hpp"

namespace drydock::replay {

namespace {

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path + ": " + std::strerror(errno));
  return {std::istreambuf_iterator<char>(in), {}};
}

using Faults = std::vector<rig_config::FaultConfig>;

Faults faults_of(const std::string& path) {
  return path.empty() ? Faults{} : rig_config::load_faults(path).value();
}

/// Describes the part of the recording and the faults. References are valid only for the same text.
std::string part_text(const record::Selection& part, const Faults& faults) {
  std::string text;
  for (const auto& name : part.only) text += (text.empty() ? "only " : ",") + name;
  if (part.from) text += fmt::format(" from {} ns", part.from->count());
  if (part.to) text += fmt::format(" to {} ns", part.to->count());
  if (text.empty()) text = "all";
  for (const auto& fault : faults)
    text += fmt::format("{} {} from {} s", &fault == &faults.front() ? ", with" : ",", fault.words,
                        fault.start_s);
  return text;
}

/// One replay with all outputs of its options. Members are in the order in which they need each
/// other.
class RigReplay {
 public:
  RigReplay(const RigReplayOptions& options, record::Recording recording, std::FILE* in,
            std::FILE* out, std::FILE* err)
      : options_(options),
        out_(out),
        err_(err),
        recording_(std::move(recording)),
        recorded_(recording_),
        other_(rig_to_play()),
        faults_(faults_of(options.faults)),
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
                                 outside_ ? &*outside_ : nullptr},
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
      RecordingProgress progress("replay", err_, [this] { return standing(); });
      bench_->play(pace, std::ref(progress));
    }
    close_outlets();
    if (!lines_.flush()) return cannot_write();
    print_summary(options_.quiet ? out_ : err_);
    const bool sound = compared() & judged();
    const bool recorded = !(recorder_ && recorder_->failed());
    return terminal::exit_of(sound && recorded && bench_->measurements() > 0);
  }

 private:
  using Stamp = measurement::Stamp;

  const rig_config::Rig& rig() const { return other_.rig; }

  OtherRig rig_to_play() const {
    if (options_.rig.empty()) return {recorded_.rig(), {}};
    auto loaded = rig_config::load_rig(options_.rig);
    if (!loaded) throw std::runtime_error(to_string(loaded.error().front()));
    return fit(std::move(*loaded), recording_, recorded_.rig());
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
    if (auto verdict = verdict_on_recording()) made.verdicts.push_back(std::move(*verdict));
    made.findings = summary::accounts_of(findings_, rig(), bench_->start());
    fmt::print(options_.quiet ? out_ : err_, "{}", to_text(made));
    summary::write_files(made, {options_.json, options_.report, options_.junit}, rig().file);
    return std::ranges::all_of(made.verdicts, &summary::Verdict::passed);
  }

  /// What is missing in a recording was judged by nobody.
  std::optional<summary::Verdict> verdict_on_recording() const {
    if (recording_.damage().empty()) return {};
    return summary::Verdict{.subject = "rig",
                            .what = "recording",
                            .measured = "damaged: " + recording_.damage(),
                            .expected = "whole"};
  }

  int cannot_write() {
    fmt::print(err_, "replay: cannot write the output\n");
    return terminal::exit_failed;
  }

  /// What the bar tells besides.
  host::RunStanding standing() const {
    host::RunStanding standing;
    if (recorder_) standing.recorded = recorder_->bytes();
    for (const auto* device : bench_->devices()) {
      const auto health = device->health(bench_->player().now());
      standing.rates_hz.emplace_back(device->name(), health.rate_hz.value_or(0));
    }
    return standing;
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
    if (!options_.check.empty()) {
      auto expected = parse_references(text_of(options_.check));
      if (!expected) throw std::runtime_error(options_.check + ": " + expected.error().line);
      if (expected->part != part_text(options_.part, faults_))
        throw std::runtime_error(fmt::format("{} is of another part of a recording: {}; this is {}",
                                             options_.check, expected->part,
                                             part_text(options_.part, faults_)));
      check_.emplace(std::move(*expected), options_.tolerance);
      followers.add(checked_.emplace(*check_, rig));
    }
    if (!options_.update_refs.empty()) {
      maker_.emplace(options_.refs_every);
      followers.add(made_.emplace(*maker_, rig));
    }
    if (is_judged()) summary_.emplace(rig, *bench_, options_.recording);
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

  /// Returns false if the replay differs from the references.
  bool compared() {
    if (maker_ && !bench_->interrupted()) {
      report::write_file(options_.update_refs,
                         to_json_text(maker_->made(part_text(options_.part, faults_))));
      fmt::print(err_, "references written: {}\n", options_.update_refs);
    }
    if (!check_) return true;
    const auto diverged = check_->finish();
    if (diverged.empty()) {
      fmt::print(err_, "as {} has it: {} messages on {} topics\n", options_.check,
                 check_->messages(), check_->topics());
      return true;
    }
    fmt::print(err_, "first divergence: {}\n", to_string(diverged.front()));
    for (std::size_t i = 1; i < diverged.size(); ++i)
      fmt::print(err_, "then: {}\n", to_string(diverged[i]));
    return false;
  }

  void print_summary(std::FILE* to) {
    const auto& rig = this->rig();
    print_account(to, rig, *bench_);
    fmt::print(to, "{}",
               summary::findings_text(summary::accounts_of(findings_, rig, bench_->start())));
    for (const auto& note : setup::pipeline_notes(rig, bench_->pipeline()))
      fmt::print(to, "{}\n", note);
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
  ReplayLines lines_;
  std::shared_ptr<host::Follower> diagnostician_;
  std::optional<host::SoundDevices> sound_devices_;
  host::FindingLog findings_;
  std::optional<host::FindingLines> said_;
  std::optional<host::StateLines> states_;
  Steps steps_;
  std::optional<Onto> onto_;
  std::optional<ReferenceCheck> check_;
  std::optional<ReferenceMaker> maker_;
  std::optional<TopicsFollower> checked_, made_;
  std::optional<host::RigRecorder> recorder_;
  std::optional<host::RigViewer> viewer_;
  std::optional<setup::Outside> outside_;  ///< empty: no other program is asked
  std::optional<ReplayBench> bench_;
  std::optional<ReplaySummary> summary_;
};

}  // namespace

bool is_recording(const std::string& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return false;
  std::array<char, mcap::magic.size()> head{};
  std::ifstream in(path, std::ios::binary);
  return in.read(head.data(), head.size()) &&
         std::memcmp(head.data(), mcap::magic.data(), head.size()) == 0;
}

int replay_rig(const RigReplayOptions& options, std::FILE* in, std::FILE* out, std::FILE* err) {
  auto recording = record::Recording::open(options.recording);
  if (!recording) {
    fmt::print(err, "replay: {}\n", recording.error().line);
    return terminal::exit_failed;
  }
  const auto refused = [&](const std::exception& error, int code) {
    fmt::print(err, "replay: {}\n", error.what());
    return code;
  };
  std::optional<RigReplay> replay;
  try {
    replay.emplace(options, std::move(*recording), in, out, err);
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

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "drivers/host/finding_lines.hpp"
#include "drivers/host/state_lines.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/terminal/interrupt_flag.hpp"
#include "drivers/terminal/terminal_screen.hpp"
#include "hil/bench/lockstep_bench.hpp"
#include "hil/bench/rig_run.hpp"
#include "hil/bench/run.hpp"
#include "hil/bench/told_log.hpp"
#include "hil/control/live_faults.hpp"
#include "hil/fault/schedule/chronicle.hpp"
#include "hil/motion/ordered/takes_orders.hpp"
#include "hil/motion/remembered_trajectory.hpp"
#include "hil/summary/program_verdict.hpp"

namespace drydock::bench {
namespace {

using measurement::Stamp;

/// A rig without a vehicle of its own: its time is that of its recordings.
bool plays_files_only(const rig_config::Rig& rig) {
  return !rig.devices.empty() &&
         std::ranges::all_of(rig.devices, [](const rig_config::DeviceConfig& device) {
           const auto uri = link::parse_uri(device.link);
           return uri && uri->recorded();
         });
}

/// Whether a run of this length ends with its recordings. A vehicle that is steered from outside
/// comes to no end of its own.
bool ends_when_played(const rig_config::Rig& rig, double duration_s) {
  if (duration_s > 0) return false;
  if (plays_files_only(rig)) return true;
  throw std::runtime_error(
      rig.file + ": its motion has no end of its own; allowed in virtual time: with --for");
}

/// A run in virtual time.
class LockstepRun {
 public:
  LockstepRun(const rig_config::Rig& rig, const RunOptions& options)
      : terminal_(terminal::erases_lines(STDOUT_FILENO)),
        start_(measurement::stamp_from_ns(rig.start_utc_ns)),
        parts_(options.parts),
        trajectory_(parts_.motion != nullptr
                        ? *parts_.motion
                        : mission_.emplace(motion::make_trajectory(rig.mission, start_))),
        duration_s_(options.duration_s > 0 ? options.duration_s
                                           : measurement::seconds(trajectory_.end() - start_)),
        until_played_(ends_when_played(rig, duration_s_)),
        run_(rig, options, trajectory_,
             {.start = start_,
              .expected_s = duration_s_,
              .when_behind = record::WhenBehind::wait,
              .others_hear_truth = false}),
        finding_lines_(rig, start_, [](const std::string& line) { fmt::print("{}\n", line); }),
        bench_(rig, trajectory_, run_.followers(), run_.on_written(),
               {.say =
                    [this, quiet = options.quiet](const std::string& line) {
                      if (!quiet) fmt::print("{}{}\n", terminal_ ? "\r" : "", line);
                    },
                .peers = parts_.peers}),
        chronicle_(bench_.faults(), start_) {
    for (auto* actor : parts_.actors) bench_.add(*actor);
    const bool prints = !options.quiet && !terminal_;
    bench_.set_on_told([this, prints](std::string_view device, std::string_view what, Stamp) {
      const auto line = told_.add(device, what);
      if (prints && !line.empty()) fmt::print("{}\n", line);
    });
    if (!prints) return;
    run_.followers().add(state_lines_);
    run_.followers().add(finding_lines_);
    chronicle_.set_on_change([this](const fault::Episode& episode) {
      fmt::print("{}\n", control::line_of(episode, start_));
    });
  }

  summary::Summary run() {
    const terminal::InterruptFlag interrupted(terminal::ClosedPipe::ends);
    const auto wall_start = std::chrono::steady_clock::now();
    const Stamp end =
        until_played_ ? Stamp::max() : start_ + measurement::from_seconds(duration_s_);
    run_.begin({start_, devices(), bench_.pipeline(), bench_.faults()});
    while (bench_.now() < end && !(until_played_ && bench_.is_played()) && !interrupted.set() &&
           !(parts_.stopped && parts_.stopped())) {
      bench_.run_until(std::min(end, bench_.now() + std::chrono::seconds{1}));
      chronicle_.follow(bench_.now());
      run_.tell_faults(bench_.now());
      run_.tell_health(bench_.now());
      run_.followers().tick(bench_.now());
      show_progress();
    }
    bench_.flush();
    summary::Summary s;
    s.mode = "lockstep";
    s.duration_s = measurement::seconds(bench_.now() - start_);
    s.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
    s.interrupted = interrupted.set();
    s.devices = run_.devices(bench_.now());
    bench_.stop();
    s.notes = told_.notes();
    if (const auto* orders = motion::orders_of(trajectory_))
      std::ranges::move(motion::notes_of(orders->counters()), std::back_inserter(s.notes));
    if (const auto* program = bench_.program()) {
      std::ranges::move(program->notes(), std::back_inserter(s.notes));
      s.verdicts.push_back(summary::verdict_of("steering", program->account()));
    }
    run_.write(s);
    control::write(chronicle_, start_, s);
    return s;
  }

 private:
  std::vector<const device::Device*> devices() const {
    std::vector<const device::Device*> all;
    for (std::size_t i = 0; i < bench_.devices(); ++i) all.push_back(&bench_.device(i));
    return all;
  }

  void show_progress() const {
    if (!terminal_ || !parts_.progress) return;
    const double done = measurement::seconds(bench_.now() - start_);
    if (until_played_)
      fmt::print("\r{:.0f} s", done);
    else
      fmt::print("\r{:.0f} s of {:.0f} s ({:.0f} %)", done, duration_s_, 100 * done / duration_s_);
    std::fflush(stdout);
  }

  bool terminal_;
  Stamp start_;
  const LockstepParts& parts_;
  std::optional<motion::RememberedTrajectory> mission_;
  const motion::Trajectory& trajectory_;
  double duration_s_;
  bool until_played_;  ///< to the end of the recordings that the devices read
  RigRun run_;
  host::StateLines state_lines_{stdout, start_};
  host::FindingLines finding_lines_;
  LockstepBench bench_;
  fault::Chronicle chronicle_;
  ToldLog told_;
};

}  // namespace

summary::Summary run_lockstep(const rig_config::Rig& rig, const RunOptions& options) {
  return LockstepRun(rig, options).run();
}

}  // namespace drydock::bench

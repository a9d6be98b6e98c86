#include "hil/bench/run.hpp"

#include "hil/report/write_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <stdexcept>

#include "drivers/terminal/exit_codes.hpp"
#include "drivers/terminal/interrupt_flag.hpp"
#include "hil/bench/short_run.hpp"
#include "hil/summary/junit.hpp"
#include "hil/summary/truth_of_rig.hpp"
#include "hil/summary/write_files.hpp"

namespace drydock::bench {
namespace {

/// Turns --expect-streaming and --expect-rms into [[expect]] blocks.
std::vector<rig_config::ExpectConfig> asked_for(const rig_config::Rig& rig,
                                                const RunOptions& options) {
  std::vector<rig_config::ExpectConfig> expects;
  if (options.expect_streaming) {
    for (const auto& d : rig.devices) {
      expects.emplace_back();
      expects.back().device = d.name;
      expects.back().state = "streaming";
    }
  }
  if (!options.expect_rms_deg) return expects;
  for (const auto& e : rig.estimators) {
    expects.emplace_back();
    expects.back().estimator = e.name;
    expects.back().figures.push_back({"estimates", {.low = 1}});
    if (!summary::truth_for_estimators(rig)) continue;
    for (const char* figure : {"roll_rms_deg", "pitch_rms_deg"})
      expects.back().figures.push_back({figure, {.high = *options.expect_rms_deg}});
  }
  return expects;
}

void print(const summary::Summary& summary, const RunOptions& options) {
  fmt::print("\n{}: {:.1f} s of bench time in {:.1f} s{}{}\n{}", summary.rig, summary.duration_s,
             summary.wall_s,
             options.lockstep ? fmt::format(", {:.0f} times real time", summary.speed()) : "",
             summary.interrupted ? " (interrupted)" : "", to_text(summary));
}

/// If a run cannot begin, the JUnit file says so too, for a CI server.
summary::Summary run_or_report(const rig_config::Rig& rig, const RunOptions& options) try {
  return options.lockstep ? run_lockstep(rig, options) : run_real_time(rig, options);
} catch (const std::exception& error) {
  if (!options.junit.empty())
    report::write_file(options.junit, summary::junit_of_failure(rig.name, rig.file, error.what()));
  throw;
}

}  // namespace

int run(const rig_config::Rig& rig, const RunOptions& options) {
  rig_config::Rig asked = rig;
  std::ranges::move(asked_for(rig, options), std::back_inserter(asked.expects));
  const terminal::InterruptFlag until_written(terminal::ClosedPipe::ends);
  summary::Summary summary = run_or_report(asked, options);
  if (auto verdict = verdict_of_short_run(summary, options.duration_s))
    summary.verdicts.push_back(std::move(*verdict));
  print(summary, options);
  std::fflush(stdout);  // the verdict is seen even where a file is written slowly
  summary::write_files(summary, {options.json, options.report, options.junit}, rig.file);
  return terminal::exit_of(std::ranges::all_of(summary.verdicts, &summary::Verdict::passed));
}

}  // namespace drydock::bench

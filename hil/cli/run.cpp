#include "hil/cli/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace drydock::cli {
namespace {

void write_file(const std::filesystem::path& path, const std::string& text) {
  if (path.has_parent_path()) {
    std::error_code ignored;  // a folder that cannot be made shows as a file that cannot be opened
    std::filesystem::create_directories(path.parent_path(), ignored);
  }
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(fmt::format("cannot write {}", path.string()));
}

double worst_rms_deg(const EstimatorSummary& e) {
  return e.whole_run ? std::max(e.whole_run->roll_rms_deg, e.whole_run->pitch_rms_deg) : 0;
}

/// One line for each expectation that the run did not meet.
std::vector<std::string> unmet(const Summary& summary, const RunOptions& options) {
  std::vector<std::string> lines;
  if (options.expect_streaming) {
    for (const auto& d : summary.devices) {
      if (d.state != "streaming")
        lines.push_back(fmt::format("{} is {}, not streaming", d.name, d.state));
    }
  }
  if (options.expect_rms_deg) {
    for (const auto& e : summary.estimators) {
      if (!(worst_rms_deg(e) <= *options.expect_rms_deg) || e.estimates == 0) {
        lines.push_back(
            fmt::format("{}: {} estimates, attitude error {:.3f} deg RMS, expected at most {} deg",
                        e.name, e.estimates, worst_rms_deg(e), *options.expect_rms_deg));
      }
    }
  }
  return lines;
}

}  // namespace

DeviceSummary summarise(const device::Device& device, const device::Health& health,
                        measurement::Provenance provenance) {
  const auto& options = device.options();
  return {.name = device.name(),
          .kind = std::string{device::to_string(options.driver.kind)},
          .protocol = options.driver.protocol,
          .link = options.link,
          .provenance = std::string{measurement::to_string(provenance)},
          .state = std::string{device::to_string(health.state)},
          .last_error = std::string{health.last_error.view()},
          .nominal_rate_hz = health.nominal_rate_hz,
          .rate_hz = health.rate_hz.value_or(0),
          .bytes_in = health.stream.bytes_in,
          .bytes_good = health.stream.bytes_good,
          .bytes_skipped = health.stream.bytes_skipped,
          .bytes_held = health.held_bytes,
          .frames = health.stream.frames,
          .bad_checksums = health.stream.bad_checksums,
          .messages = health.messages,
          .reopens = health.reopened};
}

int run(const rig_config::Rig& rig, const RunOptions& options) {
  const Summary summary =
      options.lockstep ? run_lockstep(rig, options) : run_real_time(rig, options);
  fmt::print("\n{}: {:.1f} s of bench time in {:.1f} s{}{}\n{}", summary.rig, summary.duration_s,
             summary.wall_s,
             options.lockstep ? fmt::format(", {:.0f} times real time", summary.speed()) : "",
             summary.interrupted ? " (interrupted)" : "", to_text(summary));
  if (!options.json.empty()) write_file(options.json, to_json(summary));
  if (!options.report.empty()) {
    const auto page = std::filesystem::path(options.report) / "index.html";
    write_file(page, to_html(summary));
    fmt::print("report: {}\n", page.string());
  }
  const auto misses = unmet(summary, options);
  for (const auto& miss : misses) fmt::print(stderr, "not as expected: {}\n", miss);
  return misses.empty() ? 0 : 1;
}

}  // namespace drydock::cli

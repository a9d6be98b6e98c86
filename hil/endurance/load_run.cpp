#include "hil/endurance/load_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "drivers/link/clock.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/terminal/progress_bar.hpp"
#include "drivers/terminal/terminal_screen.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "hil/bench/run.hpp"
#include "hil/report/table.hpp"
#include "hil/report/write_file.hpp"
#include "hil/validity/deadlines.hpp"
#include "hil/validity/run/host_floor.hpp"
#include "hil/validity/run/sent_and_heard.hpp"
#include "hil/validity/run/validity.hpp"

namespace drydock::endurance {
namespace {

using validity::Deadlines;
using validity::Spread;

/// Power-up is not load, so the first sample may come this long after the start.
constexpr double settles_within_s = 5;

struct LoadResult {
  summary::Summary summary;
  std::vector<Deadlines> devices;  ///< in the order of the rig
  validity::HostTimes floor;
};

/// Notes when each measurement was out of its driver, and draws a progress bar on a terminal.
class LoadWatch final : public validity::SentAndHeard {
 public:
  LoadWatch(validity::Listener& listener, double duration_s, std::FILE* bar)
      : SentAndHeard(listener),
        duration_s_(duration_s),
        bar_(bar),
        terminal_(terminal::erases_lines(fileno(bar))) {}
  ~LoadWatch() override {
    if (terminal_) fmt::print(bar_, "{}", terminal::wipe_line);
  }

  void on_start(const bench::BenchView& bench) override { start_ = bench.start; }
  void on_measurement(const measurement::Measurement& m) override {
    listener_.note(m, link::steady_now());
  }
  void tick(Stamp) override {
    if (!terminal_) return;
    const double done = measurement::seconds(link::steady_now() - start_) / duration_s_;
    fmt::print(bar_, "{}load {} {:.0f} of {:.0f} s, Ctrl-C ends", terminal::wipe_line,
               terminal::progress_bar(done), std::min(done, 1.0) * duration_s_, duration_s_);
    std::fflush(bar_);
  }

 private:
  double duration_s_;
  std::FILE* bar_;
  bool terminal_;
  Stamp start_{};
};

LoadResult measure(const rig_config::Rig& rig, const LoadOptions& options, std::FILE* bar) {
  std::vector<std::string> names;
  for (const auto& device : rig.devices) names.push_back(device.name);
  validity::Listener listener(names);
  bench::RunOptions run;
  run.duration_s = options.duration_s;
  run.quiet = true;
  LoadWatch watch(listener, options.duration_s, bar);
  run.followers = {&watch};
  LoadResult result;
  const auto begin = link::steady_now();
  validity::HostFloor host;
  result.summary = bench::run_real_time(rig, run);
  result.floor = host.stop();

  validity::Floor floor;
  const validity::HostTimes& seen = result.floor;
  for (std::size_t i = 0; i < seen.timer_at.size(); ++i)
    floor.add_timer(seen.timer_at[i], seen.timer_late_us[i]);
  for (std::size_t i = 0; i < seen.pty_at.size(); ++i)
    floor.add_link(seen.pty_at[i], seen.pty_hop_us[i]);
  const auto end = begin + measurement::from_seconds(result.summary.duration_s);
  const auto figures = listener.figures();
  for (const auto& device : rig.devices) {
    const auto first = std::ranges::find(figures, device.name, &validity::Figures::device);
    const auto last = std::find_if(first, figures.end(),
                                   [&](const auto& of) { return of.device != device.name; });
    result.devices.push_back(validity::deadlines_of(device.name, device.rate_hz,
                                                    listener.sampled_at(device.name), {first, last},
                                                    floor, {begin, end}));
  }
  return result;
}

/// Why a device fails, in words; empty if it passes.
std::vector<std::string> troubles_of(const Deadlines& d, const summary::DeviceSummary& device) {
  if (d.samples == 0) return {"no sample came out of its driver"};
  std::vector<std::string> all;
  if (d.missed > 0)
    all.push_back(fmt::format("{} of {} deadlines missed, by up to {:.1f} ms", d.missed, d.samples,
                              -d.least_margin_us / 1e3));
  if (d.lost > 0) all.push_back(fmt::format("{} of {} samples lost", d.lost, d.samples));
  if (!d.rate_held())
    all.push_back(fmt::format("{:.3f} Hz instead of {:.3f}", d.sent_hz, d.asked_hz));
  if (d.first_s > settles_within_s)
    all.push_back(fmt::format("its first sample was out after {:.1f} s", d.first_s));
  if (device.bad_checksums > 0)
    all.push_back(fmt::format("{} bad checksums", device.bad_checksums));
  if (device.reopens > 0) all.push_back(fmt::format("opened again {} times", device.reopens));
  return all;
}

std::string in_ms(double us) { return fmt::format("{:.2f}", us / 1e3); }

report::Table table_of(const LoadResult& result) {
  report::Table table{
      "responses [ms]",
      {"device", "Hz", "Hz sent", "samples", "lost", "missed", "p50", "p99", "largest", "period",
       "least margin"},
      {},
      "From the sample until its driver has it out. Missed: later than a period "
      "and what the bare timer and pty below took in the same second; least margin: "
      "what was left of that."};
  for (const Deadlines& d : result.devices)
    table.rows.push_back(
        {d.device, fmt::format("{:g}", d.asked_hz), fmt::format("{:.3f}", d.sent_hz),
         std::to_string(d.samples), std::to_string(d.lost), std::to_string(d.missed),
         in_ms(d.response.p50_us), in_ms(d.response.p99_us), in_ms(d.response.largest_us),
         in_ms(1e6 / d.asked_hz), in_ms(d.least_margin_us)});
  const auto add_floor = [&](const char* name, const std::vector<double>& values) {
    const Spread s = validity::spread_of(values);
    table.rows.push_back({name, "", "", std::to_string(values.size()), "", "", in_ms(s.p50_us),
                          in_ms(s.p99_us), in_ms(s.largest_us), "", ""});
  };
  add_floor("this host's timer", result.floor.timer_late_us);
  add_floor("a byte through a pty", result.floor.pty_hop_us);
  return table;
}

nlohmann::ordered_json spread_json_ms(const Spread& s) {
  return {
      {"p50_ms", s.p50_us / 1e3}, {"p99_ms", s.p99_us / 1e3}, {"largest_ms", s.largest_us / 1e3}};
}

nlohmann::ordered_json json_of(const LoadResult& result, bool passed) {
  nlohmann::ordered_json json{
      {"rig", result.summary.rig},
      {"duration_s", result.summary.duration_s},
      {"interrupted", result.summary.interrupted},
      {"passed", passed},
      {"timer", spread_json_ms(validity::spread_of(result.floor.timer_late_us))},
      {"pty", spread_json_ms(validity::spread_of(result.floor.pty_hop_us))},
      {"devices", nlohmann::ordered_json::array()}};
  for (std::size_t i = 0; i < result.devices.size(); ++i) {
    const Deadlines& d = result.devices[i];
    json["devices"].push_back({{"device", d.device},
                               {"asked_hz", d.asked_hz},
                               {"sent_hz", d.sent_hz},
                               {"samples", d.samples},
                               {"lost", d.lost},
                               {"stalled", d.stalled},
                               {"missed", d.missed},
                               {"response", spread_json_ms(d.response)},
                               {"period_ms", 1e3 / d.asked_hz},
                               {"least_margin_ms", d.least_margin_us / 1e3},
                               {"first_s", d.first_s},
                               {"troubles", troubles_of(d, result.summary.devices[i])}});
  }
  return json;
}

/// A FAIL means little if the bare timer of the machine was later than one period of the fastest
/// device.
std::string host_note(const rig_config::Rig& rig, const validity::HostTimes& floor) {
  double quickest_hz = 0;
  for (const auto& device : rig.devices) quickest_hz = std::max(quickest_hz, device.rate_hz);
  const Spread timer = validity::spread_of(floor.timer_late_us);
  if (quickest_hz == 0 || timer.p99_us < 1e6 / quickest_hz) return "";
  return fmt::format(
      "this machine's bare timer was {} ms late at p99, more than the {} ms of the quickest "
      "device: "
      "measure where nothing else runs\n",
      in_ms(timer.p99_us), in_ms(1e6 / quickest_hz));
}

}  // namespace

int load_run(const rig_config::Rig& whole, const LoadOptions& options, std::FILE* out,
             std::FILE* bar) {
  const LoadResult result = measure(validity::with_truth(whole), options, bar);
  fmt::print(out, "{}", report::to_text(table_of(result)));
  for (const auto& note : result.summary.notes) fmt::print(out, "{}\n", note);
  std::size_t samples = 0, stalled = 0, failed = 0;
  for (std::size_t i = 0; i < result.devices.size(); ++i) {
    samples += result.devices[i].samples;
    stalled += result.devices[i].stalled;
    const auto troubles = troubles_of(result.devices[i], result.summary.devices[i]);
    for (const auto& trouble : troubles)
      fmt::print(out, "{}: {}\n", result.devices[i].device, trouble);
    failed += !troubles.empty();
  }
  if (stalled > 0)
    fmt::print(out, "{} samples fell to stalls of this machine longer than their period\n",
               stalled);
  const summary::Summary& run = result.summary;
  const bool passed = failed == 0 && !run.interrupted;
  if (!options.json.empty())
    report::write_file(options.json, text::json_of_any_text(json_of(result, passed)) + "\n");
  if (passed)
    fmt::print(out,
               "PASS {} devices, {} samples in {:.0f} s: no deadline missed, none lost, every rate "
               "held\n",
               result.devices.size(), samples, run.duration_s);
  else
    fmt::print(
        out, "FAIL {} of {} devices in {:.0f} s{}\n", failed, result.devices.size(), run.duration_s,
        run.interrupted ? fmt::format(", ended by Ctrl-C before {:g} s", options.duration_s) : "");
  if (failed > 0) fmt::print(out, "{}", host_note(whole, result.floor));
  if (run.interrupted) return terminal::exit_interrupted;
  return terminal::exit_of(passed);
}

}  // namespace drydock::endurance

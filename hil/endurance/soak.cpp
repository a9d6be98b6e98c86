#include "hil/endurance/soak.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "hil/bench/run.hpp"
#include "hil/bench/short_run.hpp"
#include "hil/endurance/soak_watch.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "hil/report/html.hpp"
#include "hil/report/write_file.hpp"

namespace drydock::endurance {

namespace {

/// Resident memory at the end minus that after half of the run.
double growth_mb(const summary::ResidentTrace& resident) {
  const std::size_t count = resident.megabytes.size();
  return count < 10 ? 0 : resident.megabytes.back() - resident.megabytes[count / 2];
}

std::vector<std::string> troubles_of(const summary::Summary& summary, const SoakWatch& watch,
                                     double most_growth_mb) {
  std::vector<std::string> all = watch.troubles();
  const double grown = growth_mb(summary.resident);
  if (grown > most_growth_mb)
    all.push_back(fmt::format("memory grew by {:.1f} MB in the second half", grown));
  for (const auto& estimator : summary.estimators)
    if (estimator.whole_run && !std::isfinite(estimator.whole_run->roll_rms_deg))
      all.push_back(estimator.name + ": its estimates are no numbers");
  return all;
}

std::string words_line(const SoakWatch& watch) {
  std::string line;
  for (const auto& [word, count] : watch.set_by_word())
    line += fmt::format("{}{} {}", line.empty() ? "" : ", ", word, count);
  return line;
}

std::string alarms_line(const SoakWatch& watch) {
  return fmt::format(
      "{} findings, {} of them of bed or sky; {} are false alarms in {:.2f} h without a fault",
      watch.findings(), watch.of_surroundings(), watch.false_alarms(), watch.quiet_s() / 3600);
}

void print(const summary::Summary& summary, const SoakWatch& watch,
           const std::vector<std::string>& troubles, std::FILE* out) {
  fmt::print(out, "{}", to_text(summary));
  fmt::print(out, "{} faults: {}\n", watch.faults_set(), words_line(watch));
  fmt::print(out, "{}\n", alarms_line(watch));
  if (!summary.resident.megabytes.empty())
    fmt::print(out, "memory: {:.1f} MB at the end, {:+.1f} MB against half of the run\n",
               summary.resident.megabytes.back(), growth_mb(summary.resident));
  for (const auto& trouble : troubles) fmt::print(out, "FAIL {}\n", trouble);
  if (troubles.empty())
    fmt::print(out,
               "PASS {} looks: no growth in memory, no state stuck, every byte accounted for, "
               "every value a number, no false alarm\n",
               watch.looks());
}

std::string json_of(const summary::Summary& summary, const SoakWatch& watch,
                    const std::vector<std::string>& troubles) {
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(summary::to_json(summary));
  json["faults"] = watch.faults_set();
  json["faults_by_word"] = watch.set_by_word();
  json["resident_growth_mb"] = growth_mb(summary.resident);
  json["findings_begun"] = watch.findings();
  json["findings_of_surroundings"] = watch.of_surroundings();
  json["false_alarms"] = watch.false_alarms();
  json["hours_without_fault"] = watch.quiet_s() / 3600;
  json["troubles"] = troubles;
  return text::json_of_any_text(json) + "\n";
}

std::string page_of(const summary::Summary& summary, const SoakWatch& watch,
                    const std::vector<std::string>& troubles) {
  report::Figure memory;
  memory.title = "Resident memory of the process";
  memory.x_label = "time, days";
  memory.y_label = "MB";
  report::Curve curve{"resident", {}, summary.resident.megabytes};
  for (const double t : summary.resident.t_s) curve.x.push_back(t / 86400);
  memory.curves = {curve};
  std::string body =
      fmt::format("<p>{:.1f} days under {} faults: {}.</p>", summary.duration_s / 86400,
                  watch.faults_set(), report::html::escaped(words_line(watch)));
  body += "<p>" + alarms_line(watch) + ".</p>";
  body += troubles.empty() ? "<p class=ok>No trouble.</p>" : "<ul class=bad>";
  for (const auto& trouble : troubles) body += "<li>" + report::html::escaped(trouble);
  if (!troubles.empty()) body += "</ul>";
  body += report::html::figure(memory);
  body += "<pre>" + report::html::escaped(to_text(summary)) + "</pre>";
  return report::html::page("Soak of " + summary.rig, body);
}

}  // namespace

int soak(rig_config::Rig rig, const SoakOptions& options, std::FILE* out) {
  // Where the kernel gives huge pages to all, as Debian's does, resident memory grows by two
  // megabytes when one byte of such a page is touched, and that looks like a leak.
  prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0);
  rig.seed = options.seed;
  SoakWatch watch(rig, options.seed,
                  options.faults ? std::optional(options.fault_interval_s) : std::nullopt,
                  options.rest_s);
  bench::RunOptions run;
  run.duration_s = options.duration_s;
  if (const auto last = motion::flight_s(rig); last && *last < run.duration_s) {
    run.duration_s = *last;
    fmt::print(out, "the flight of its mission ends after {:.1f} s, and the soak with it\n", *last);
  }
  run.quiet = true;
  run.curve_points = 300;  // stored curves must not look like a leak
  run.followers = {&watch};
  const summary::Summary summary = bench::run_lockstep(rig, run);
  auto troubles = troubles_of(summary, watch, options.most_growth_mb);
  if (bench::verdict_of_short_run(summary, run.duration_s))
    troubles.push_back(bench::short_run_in_words(summary, run.duration_s));
  print(summary, watch, troubles, out);
  if (!options.json.empty()) report::write_file(options.json, json_of(summary, watch, troubles));
  if (!options.report.empty())
    report::write_file(options.report + "/index.html", page_of(summary, watch, troubles));
  if (summary.interrupted) return terminal::exit_interrupted;
  return terminal::exit_of(troubles.empty());
}

}  // namespace drydock::endurance

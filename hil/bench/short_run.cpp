#include "hil/bench/short_run.hpp"

#include <fmt/format.h>

namespace drydock::bench {

namespace {

/// "3600000", "0.5"; never with an exponent.
std::string seconds_in_words(double seconds) {
  auto text = fmt::format("{:.3f}", seconds);
  text.resize(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

std::optional<summary::Verdict> verdict_of_short_run(const summary::Summary& summary,
                                                     double asked_s) {
  constexpr double least_s = 1e-3;  // that of the shortest run in real time
  if (!(summary.duration_s < asked_s - least_s)) return {};
  summary::Verdict verdict;
  verdict.subject = "rig";
  verdict.what = "duration_s";
  verdict.measured = fmt::format("{:.1f}{}", summary.duration_s,
                                 summary.interrupted ? ", then a signal ended the run" : "");
  verdict.expected = seconds_in_words(asked_s);
  return verdict;
}

std::string short_run_in_words(const summary::Summary& summary, double asked_s) {
  return fmt::format("a run of {:.1f} s, not of {} s{}", summary.duration_s,
                     seconds_in_words(asked_s), summary.interrupted ? ": a signal ended it" : "");
}

}  // namespace drydock::bench

#include "hil/bench/short_run.hpp"

#include <fmt/format.h>

namespace drydock::bench {

std::optional<summary::Verdict> verdict_of_short_run(const summary::Summary& summary,
                                                     double asked_s) {
  constexpr double least_s = 1e-3;  // that of the shortest run in real time
  if (!(summary.duration_s < asked_s - least_s)) return {};
  summary::Verdict verdict;
  verdict.subject = "rig";
  verdict.what = "duration_s";
  verdict.measured = fmt::format("{:.1f}{}", summary.duration_s,
                                 summary.interrupted ? ", then a signal ended the run" : "");
  verdict.expected = fmt::format("{:g}", asked_s);
  return verdict;
}

}  // namespace drydock::bench

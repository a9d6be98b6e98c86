#include "hil/study/run/study_timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

namespace drydock::study {
namespace {

constexpr std::size_t timed_steps = 2000, repetitions = 150;

/// Processor time of this thread, ns. It excludes the work of other programs.
double processor_time() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

double ns_per_step(study::Workload& workload) {
  const double begin = processor_time();
  workload.run(timed_steps);
  return (processor_time() - begin) / timed_steps;
}

double median(std::vector<double>& times) {
  const auto half_way = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), half_way, times.end());
  return *half_way;
}

}  // namespace

void add_step_times(std::vector<study::Workload> workloads, study::Result& result) {
  // The workloads alternate, so that other load on the machine affects all of them equally.
  std::vector<std::vector<double>> times(workloads.size());
  for (std::size_t i = 0; i < repetitions; ++i)
    for (std::size_t w = 0; w < workloads.size(); ++w)
      times[w].push_back(ns_per_step(workloads[w]));

  report::Table table{"Time per step on this machine",
                      {"algorithm", "ns", "multiple of the first"},
                      {},
                      fmt::format("median of {} times {} steps", repetitions, timed_steps)};
  double first = 0;
  for (std::size_t w = 0; w < workloads.size(); ++w) {
    const double ns = median(times[w]);
    if (w == 0) first = ns;
    table.rows.push_back(
        {workloads[w].name, fmt::format("{:.0f}", ns), fmt::format("{:.2f}", ns / first)});
    result.json[workloads[w].key]["ns_per_step"] = ns;
  }
  result.tables.push_back(std::move(table));
}

}  // namespace drydock::study

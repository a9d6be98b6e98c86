#pragma once

#include <algorithm>
#include <cstdint>
#include <exception>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "hil/sensor/random.hpp"

/// Many runs of one experiment on several threads. The result does not depend on their number.
namespace drydock::study {

struct Options {
  std::size_t runs = 100;
  std::uint64_t seed = 1;
  unsigned jobs = 1;           ///< threads; the result does not depend on it
  std::string ephemeris = {};  ///< navigation file for a study that needs one; empty: its own
  std::vector<std::string> cases = {};  ///< names of cases of the study; empty: all
  std::string registers = {};           ///< that hold runs side by side; empty: the widest
};

/// Observes a campaign. Calls come one at a time, from any thread.
class Progress {
 public:
  virtual ~Progress() = default;
  virtual void on_run(std::string_view campaign, std::size_t done, std::size_t of) = 0;
  virtual bool stopped() const = 0;  ///< true: no more runs begin
};

/// The random numbers of `stream` in one run. They depend only on (seed, run, stream).
inline sensor::RandomStream stream_of(std::uint64_t seed, std::size_t run,
                                      std::string_view stream) {
  return {seed, "run " + std::to_string(run), stream};
}

/// Calls `run(k, n)` for the runs k, k + 1, ... k + n - 1 of batches of at most `batch`,
/// independently of each other. It returns the n outcomes. Calls `collect(k, outcome)` in the order
/// of k, one at a time. Returns the number of collected runs. When `progress` stops the campaign,
/// the runs that have begun are finished. So the collected result equals, to the last bit, that of
/// a campaign with this number of runs. An exception of `run` or `collect` ends the campaign and is
/// thrown again.
template <class Run, class Collect>
std::size_t campaign_by_batches(std::string_view name, const Options& options, std::size_t batch,
                                Progress& progress, Run&& run, Collect&& collect) {
  using Outcomes = decltype(run(std::size_t{}, std::size_t{}));
  const auto jobs =
      std::clamp<std::size_t>(options.jobs, 1, std::max<std::size_t>(options.runs, 1));
  // As many for each thread, so that all of them end together.
  const std::size_t rounds = (options.runs + batch * jobs - 1) / (batch * jobs);
  const std::size_t batches = std::min(options.runs, rounds * jobs);
  std::mutex mutex;  // protects everything below
  std::size_t begun = 0, collected = 0;
  std::map<std::size_t, typename Outcomes::value_type> early;  // before a run with a lower number
  std::exception_ptr failure;

  const auto next = [&](std::size_t& k, std::size_t& n) {
    const std::lock_guard lock(mutex);
    if (failure || begun == batches || progress.stopped()) return false;
    k = options.runs * begun / batches;
    n = options.runs * ++begun / batches - k;
    return true;
  };
  const auto take = [&](std::size_t k, Outcomes&& outcomes) {
    const std::lock_guard lock(mutex);
    for (auto& outcome : outcomes) early.emplace(k++, std::move(outcome));
    while (!early.empty() && early.begin()->first == collected) {
      collect(collected, std::move(early.begin()->second));
      early.erase(early.begin());
      progress.on_run(name, ++collected, options.runs);
    }
  };
  const auto work = [&] {
    try {
      for (std::size_t k = 0, n = 0; next(k, n);) take(k, run(k, n));
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < jobs; ++i) others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  return collected;
}

/// The same one run at a time: calls `run(k)`.
template <class Run, class Collect>
std::size_t campaign(std::string_view name, const Options& options, Progress& progress, Run&& run,
                     Collect&& collect) {
  using Outcome = decltype(run(std::size_t{}));
  return campaign_by_batches(
      name, options, 1, progress,
      [&](std::size_t k, std::size_t) {
        std::vector<Outcome> one;
        one.push_back(run(k));
        return one;
      },
      collect);
}

}  // namespace drydock::study

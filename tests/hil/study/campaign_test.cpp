#include "hil/study/campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "hil/study/ensemble.hpp"

namespace drydock::study {
namespace {

using testing::ElementsAre;

/// Stops after this number of runs.
class Watcher final : public Progress {
 public:
  explicit Watcher(std::size_t stop_after = SIZE_MAX) : stop_after_(stop_after) {}
  void on_run(std::string_view, std::size_t done, std::size_t of) override {
    seen.push_back(done);
    total = of;
  }
  bool stopped() const override { return seen.size() >= stop_after_; }

  std::vector<std::size_t> seen;
  std::size_t total = 0;

 private:
  std::size_t stop_after_;
};

/// A run whose duration depends on its number irregularly, so that threads overtake each other.
double uneven_run(std::uint64_t seed, std::size_t k) {
  auto random = stream_of(seed, k, "noise");
  double sum = 0;
  for (std::size_t i = 0; i < 1000 + k * 7919 % 13 * 3000; ++i) sum += random.normal();
  return sum;
}

/// The floating-point sum of all runs. It is the same only if the order of addition is the same.
struct Total {
  double sum = 0;
  std::vector<std::size_t> order;
  std::size_t runs = 0;
};

Total total_of(const Options& options, Progress& progress) {
  Total total;
  total.runs = campaign(
      "test", options, progress, [&](std::size_t k) { return uneven_run(options.seed, k); },
      [&](std::size_t k, double outcome) {
        total.order.push_back(k);
        total.sum += outcome;
      });
  return total;
}

Total total_of(const Options& options) {
  Watcher watcher;
  return total_of(options, watcher);
}

TEST(Campaign, GivesTheSameToTheLastBitWithAnyNumberOfJobs) {
  const auto alone = total_of({40, 5, 1});
  std::vector<std::size_t> counted(40);
  std::iota(counted.begin(), counted.end(), 0);
  EXPECT_EQ(alone.order, counted);
  for (const unsigned jobs : {2U, 3U, 8U, 64U}) {
    const auto together = total_of({40, 5, jobs});
    EXPECT_EQ(together.order, counted);
    EXPECT_EQ(together.sum, alone.sum) << jobs;
  }
  EXPECT_NE(total_of({40, 6, 1}).sum, alone.sum);
}

TEST(Campaign, StoppedItIsAWholeCampaignOfTheRunsDone) {
  for (const unsigned jobs : {1U, 4U}) {
    Watcher watcher(10);
    const auto stopped = total_of({1000, 5, jobs}, watcher);
    EXPECT_GE(stopped.runs, 10U);
    EXPECT_LT(stopped.runs, 1000U);  // may include runs after a slow one
    EXPECT_EQ(stopped.sum, total_of({stopped.runs, 5, 1}).sum);
  }
}

TEST(Campaign, ReportsEveryRunInItsTurn) {
  Watcher watcher;
  total_of({5, 1, 3}, watcher);
  EXPECT_THAT(watcher.seen, ElementsAre(1, 2, 3, 4, 5));
  EXPECT_EQ(watcher.total, 5U);
}

TEST(Campaign, UsesSeveralThreads) {
  std::atomic<int> inside = 0, most = 0;
  Watcher watcher;
  campaign(
      "threads", {4, 1, 4}, watcher,
      [&](std::size_t) {
        const int now = ++inside;
        int before = most;
        while (before < now && !most.compare_exchange_weak(before, now)) {
        }
        // All four threads meet here, unless they run one after another.
        for (int i = 0; most < 4 && i < 20'000'000; ++i) std::this_thread::yield();
        --inside;
        return 0;
      },
      [](std::size_t, int) {});
  EXPECT_EQ(most, 4);
}

TEST(Campaign, WhatARunThrowsEndsIt) {
  Watcher watcher;
  const auto failing = [&] {
    campaign(
        "failing", {100, 1, 4}, watcher,
        [](std::size_t k) {
          if (k == 7) throw std::runtime_error("run 7");
          return k;
        },
        [](std::size_t, std::size_t) {});
  };
  EXPECT_THROW(failing(), std::runtime_error);
  EXPECT_LE(watcher.seen.size(), 7U);
}

TEST(Campaign, BatchesHaveEveryRunOnceAndAreAsManyForEachThread) {
  Options options{.runs = 21, .jobs = 2};
  std::mutex mutex;
  std::vector<std::pair<std::size_t, std::size_t>> batches;
  std::vector<std::size_t> order;
  Watcher watcher;
  const auto collected = campaign_by_batches(
      "test", options, 8, watcher,
      [&](std::size_t first, std::size_t runs) {
        const std::lock_guard lock(mutex);
        batches.emplace_back(first, runs);
        std::vector<std::size_t> outcomes(runs);
        std::iota(outcomes.begin(), outcomes.end(), first);
        return outcomes;
      },
      [&](std::size_t k, std::size_t outcome) {
        EXPECT_EQ(k, outcome);
        order.push_back(k);
      });
  EXPECT_EQ(collected, 21U);
  EXPECT_TRUE(std::ranges::is_sorted(order));
  std::ranges::sort(batches);
  EXPECT_THAT(batches,
              ElementsAre(std::pair(0, 5), std::pair(5, 5), std::pair(10, 5), std::pair(15, 6)));
  EXPECT_EQ(watcher.seen.back(), 21U);
}

TEST(Campaign, RunsAndStreamsDrawIndependently) {
  const auto first = [](std::uint64_t seed, std::size_t run, const char* stream) {
    return stream_of(seed, run, stream).next();
  };
  EXPECT_EQ(first(1, 2, "imu"), first(1, 2, "imu"));
  EXPECT_NE(first(1, 2, "imu"), first(1, 3, "imu"));
  EXPECT_NE(first(1, 2, "imu"), first(1, 2, "log"));
  EXPECT_NE(first(1, 2, "imu"), first(2, 2, "imu"));
  EXPECT_NE(first(1, 12, "imu"), first(11, 2, "imu"));
}

TEST(Ensemble, MeanDeviationAndRmsAreThoseOfTheTextbook) {
  Ensemble errors(2);
  for (const double x : {2., 4., 4., 4., 5., 5., 7., 9.}) errors.add({x, -1});
  EXPECT_EQ(errors.runs(), 8U);
  EXPECT_DOUBLE_EQ(errors.mean(0), 5);
  EXPECT_DOUBLE_EQ(errors.deviation(0), 2);
  EXPECT_DOUBLE_EQ(errors.rms(0), std::sqrt(29));
  EXPECT_DOUBLE_EQ(errors.mean(1), -1);
  EXPECT_DOUBLE_EQ(errors.deviation(1), 0);
}

}  // namespace
}  // namespace drydock::study

#include "hil/scorecard/copies.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <limits>
#include <stdexcept>

#include "hil/scorecard/score_bytes.hpp"

namespace drydock::scorecard {
namespace {

class Quiet final : public study::Progress {
 public:
  explicit Quiet(std::size_t most = std::numeric_limits<std::size_t>::max()) : most_(most) {}
  void on_run(std::string_view, std::size_t done, std::size_t) override { done_ = done; }
  bool stopped() const override { return done_ >= most_; }

 private:
  std::size_t most_, done_ = 0;
};

study::Options options(std::size_t runs, unsigned jobs) {
  return {.runs = runs, .seed = 1, .jobs = jobs};
}

TEST(Copies, AreCollectedInTheOrderOfTheRunsWhateverTheirNumber) {
  std::string all = "0123456789abcdefghij", before = all;
  for (const unsigned jobs : {1U, 3U, 50U}) {
    Quiet progress;
    std::string collected;
    const auto run = [&](std::size_t k) {
      all[k] = '?';  // of its own copy
      return std::string(10'000 * (k % 3), '.') + before[k];
    };
    const auto count = in_copies("c", options(20, jobs), progress, run,
                                 [&](std::string&& said) { collected += said.back(); });
    EXPECT_EQ(count, 20u);
    EXPECT_EQ(collected, before) << jobs;
    EXPECT_EQ(all, before) << "a run changed the original";
  }
}

TEST(Copies, ARunThatThrowsEndsThemAllWithItsWords) {
  Quiet progress;
  const auto run = [](std::size_t k) -> std::string {
    if (k == 4) throw std::runtime_error("the fifth has no sea");
    return "";
  };
  try {
    in_copies("c", options(100, 3), progress, run, [](std::string&&) {});
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "the fifth has no sea");
  }
}

TEST(Copies, ARunThatIsKilledIsNamedWithItsSignal) {
  Quiet progress;
  const auto run = [](std::size_t k) -> std::string {
    if (k == 1) ::raise(SIGKILL);
    return "";
  };
  try {
    in_copies("c", options(3, 1), progress, run, [](std::string&&) {});
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "run 1 was ended by Killed (signal 9)");
  }
}

TEST(Copies, NoMoreBeginWhenTheProgressStops) {
  Quiet progress(5);
  const auto run = [](std::size_t) { return std::string(); };
  EXPECT_EQ(in_copies("c", options(100, 1), progress, run, [](std::string&&) {}), 5u);
}

TEST(ScoreBytes, KeepEveryNumberToTheLastBit) {
  Score score;
  score.device = "dvl";
  score.detect_s = 0.1;
  score.lost = -3;
  score.wrong = std::numeric_limits<std::uint64_t>::max();
  score.finding = {.found_s = 1.0 / 3, .word = "bias", .right_device = true};
  auto& leveling = score.estimators.emplace_back();
  leveling.name = "leveling";
  leveling.error_deg = std::numeric_limits<double>::infinity();
  leveling.usual_deg = 5e-324;
  leveling.nees = 0.0;
  const Score same = score_from(to_bytes(score));
  EXPECT_EQ(same.device, "dvl");
  EXPECT_EQ(same.detect_s, 0.1);
  EXPECT_FALSE(same.recover_s);
  EXPECT_EQ(same.lost, -3);
  EXPECT_EQ(same.wrong, 18'446'744'073'709'551'615u);
  EXPECT_EQ(same.finding.found_s, 1.0 / 3);
  EXPECT_EQ(same.finding.word, "bias");
  EXPECT_TRUE(same.finding.right_device);
  ASSERT_EQ(same.estimators.size(), 1u);
  EXPECT_EQ(same.estimators[0].error_deg, std::numeric_limits<double>::infinity());
  EXPECT_EQ(same.estimators[0].usual_deg, 5e-324);
  EXPECT_EQ(same.estimators[0].nees, 0.0);
  EXPECT_FALSE(same.estimators[0].usual_m);
}

}  // namespace
}  // namespace drydock::scorecard

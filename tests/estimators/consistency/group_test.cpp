#include "estimators/consistency/group.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <random>

#include "drivers/measurement/units.hpp"

namespace drydock::consistency {
namespace {

constexpr TestFacts facts_of(double floor, double wander) {
  TestFacts facts;
  facts.floor = floor;
  facts.wander = wander;
  return facts;
}
constexpr TestFacts exact = facts_of(0.02, 0.001), rough = facts_of(0.05, 0.003);

/// Witnesses of a constant speed, with white noise of known deviation.
class Sailing {
 public:
  explicit Sailing(unsigned seed = 1) : random_(seed) {}
  void add(double sigma, const TestFacts& facts, double bias = 0) {
    group.add({static_cast<std::uint16_t>(sigmas_.size())}, facts);
    sigmas_.push_back(sigma);
    biases_.push_back(bias);
  }

  /// `seen`: how many of the witnesses speak. Returns how often a test fired.
  int run(double seconds, std::size_t seen, bool anchored = false) {
    int fired = 0;
    for (int i = 0; i < std::lround(seconds / dt); ++i) {
      at_ += measurement::from_seconds(dt);
      ++serial_;
      for (std::size_t k = 0; k < seen; ++k)
        group.see(k, 3 + biases_[k] + sigmas_[k] * normal_(random_), serial_);
      group.settle(at_, dt, [](const Devices&) { return false; });
      if (anchored) group.anchor(dt);
      for (const Witness& one : group.witnesses()) fired += one.test.fired() ? 1 : 0;
    }
    return fired;
  }

  Group group;

 private:
  static constexpr double dt = 0.2;
  std::vector<double> sigmas_, biases_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  Stamp at_{std::chrono::seconds{1000}};
  std::uint64_t serial_ = 0;
};

/// A rig may have 256 devices: those beyond the group's places are not compared, and harm nothing.
TEST(Group, AWitnessBeyondTheLastPlaceIsNoWitness) {
  Group group;
  for (std::size_t i = 0; i < Group::most; ++i) EXPECT_EQ(group.add({0}, exact), i);
  const std::size_t beyond = group.add({1}, exact);
  EXPECT_EQ(beyond, Group::most);
  group.see(beyond, 1e9, 1);
  group.restart(beyond);
  group.settle(Stamp{}, 0.2, [](const Devices&) { return false; });
  EXPECT_EQ(group.value(), std::nullopt);
}

/// Each differs from the median of the two by half of the log's noise, which is twice the floor of
/// the log's test: 8 hours of a dive in which the receiver is under water.
TEST(Group, DoubtsNoneOfAPairForTheNoiseOfTheOther) {
  Sailing sailing;
  sailing.add(0.005, exact);
  sailing.add(0.15, rough);
  sailing.add(0.03, exact);
  EXPECT_EQ(sailing.run(600, 3), 0);
  EXPECT_EQ(sailing.run(8 * 3600, 2), 0);
}

/// A DVL, a receiver and a log that begins later: while both others err to one side, the median
/// leaves the DVL, which is no fault of it.
TEST(Group, DoesNotDoubtTheBestOfThreeForTheNoiseOfBothOthers) {
  int fired = 0;
  for (unsigned seed = 1; seed <= 500; ++seed) {
    Sailing sailing(seed);
    sailing.add(0.01, exact);
    sailing.add(0.05, facts_of(0.04, 0.001));
    sailing.add(0.11, rough);
    sailing.run(15, 2);
    fired += sailing.run(60, 3);
  }
  EXPECT_EQ(fired, 0);
}

TEST(Group, DrawsTheMedianOfItsOffsetsToZeroAndKeepsTheirDifferences) {
  Sailing sailing;
  sailing.add(1e-4, exact, 0.1);
  sailing.add(1e-4, exact, 0.2);
  sailing.add(1e-4, exact, 0.6);
  sailing.run(3000, 3, true);
  const auto witnesses = sailing.group.witnesses();
  EXPECT_NEAR(*sailing.group.value(), 3.2, 0.001) << "the median of all";
  EXPECT_NEAR(witnesses[1].test.offset() - witnesses[0].test.offset(), 0.1, 0.001);
  EXPECT_NEAR(witnesses[2].test.offset() - witnesses[0].test.offset(), 0.5, 0.001);
}

/// The receiver of a car on a vehicle under water, whose recording ends: nothing of it remains.
TEST(Group, ForgetsAWitnessThatIsFarOffAndThenSilent) {
  Sailing sailing;
  sailing.add(1e-4, exact);
  sailing.add(1e-4, exact);
  sailing.add(1e-4, exact, 10);
  sailing.run(20, 3, true);
  EXPECT_EQ(sailing.run(3600, 2, true), 0);
  EXPECT_NEAR(*sailing.group.value(), 3, 0.001) << "what both say";
}

/// Two nodes tell the turns of one shaft, and one law makes both speeds: if it is wrong they are
/// not two against the two others.
TEST(Group, GivesOneVoteToWitnessesThatShareAnError) {
  Group group;
  for (std::uint16_t k = 0; k < 4; ++k) group.add({k}, exact, nullptr, k >= 2);
  Stamp at{std::chrono::seconds{1000}};
  for (std::uint64_t i = 0; i < 400; ++i) {
    at += std::chrono::milliseconds{200};
    for (std::uint16_t k = 0; k < 4; ++k) group.see(k, i > 300 && k >= 2 ? 3.2 : 3, i + 1);
    group.settle(at, 0.2, [](const Devices&) { return false; });
  }
  const auto witnesses = group.witnesses();
  EXPECT_EQ(witnesses[0].test.suspicion() + witnesses[1].test.suspicion(), 0);
  EXPECT_TRUE(witnesses[2].test.fired() && witnesses[3].test.fired());
}

/// Two gauges of depth, and what three DVLs add up to, from the velocity `down_mps` from 60 s on.
struct Dive {
  Group group;
  std::array<double, 3> down_mps{};

  explicit Dive(std::array<double, 3> wrong_mps) : down_mps(wrong_mps) {
    auto sum = facts_of(0.08, 0.03);
    sum.sum_above = 0;
    sum.excused_by_kin = true;
    for (std::uint16_t k = 0; k < 5; ++k)
      group.add({k}, k < 2 ? facts_of(0.08, 0.005) : sum, nullptr, k >= 2);
    for (std::uint64_t i = 0; i < 450; ++i) {
      const double t = 0.2 * static_cast<double>(i), wrong_s = std::max(0.0, t - 60);
      for (std::size_t k = 0; k < 5; ++k) group.see(k, k < 2 ? 0 : down_mps[k - 2] * wrong_s, i);
      group.settle(Stamp{measurement::from_seconds(1000 + t)}, 0.2,
                   [](const Devices&) { return false; });
    }
  }
  int fired() const {
    return static_cast<int>(
        std::ranges::count_if(group.witnesses(), [](const Witness& w) { return w.test.fired(); }));
  }
};

/// The level that all of them take was wrong: a tilt of 2 degrees at 1.5 m/s.
TEST(Group, DoubtsNoDvlForTheDirectionOfGravityThatAllShare) {
  EXPECT_EQ(Dive({0.05, 0.052, 0.048}).fired(), 0);
}

TEST(Group, DoubtsADvlThatGoesItsOwnWay) {
  const Dive dive({0, 0.05, 0});
  EXPECT_EQ(dive.fired(), 1);
  EXPECT_TRUE(dive.group.witnesses()[3].test.fired());
}

/// Three headings of a vehicle that turns by 6 degrees a second. From `lost_s` on, the third is a
/// course that is silent for `silent_s`, as that of a receiver under water. Its first value after
/// that is `away_rad` off.
struct TurningHeadings {
  Group group{2 * std::numbers::pi};
  double turn_radps = 6 * units::degree, lost_s = 100, silent_s = 0, away_rad = 0;

  const Witness& sail(double seconds) {
    constexpr double dt = 0.2;
    for (std::uint16_t k = 0; k < 3; ++k)
      group.add({k}, facts_of(1 * units::degree, 0.05 * units::degree));
    for (std::uint64_t i = 1; static_cast<double>(i) * dt < seconds; ++i) {
      const double t = static_cast<double>(i) * dt, heading = turn_radps * t;
      const bool comes_back = t >= lost_s + silent_s;
      group.see(0, heading, i);
      group.see(1, heading + 20 * units::degree, i);
      if (t < lost_s || comes_back)
        group.see(2, std::remainder(heading + (comes_back ? away_rad : 0), 2 * std::numbers::pi),
                  i);
      group.settle(Stamp{measurement::from_seconds(1000 + t)}, dt,
                   [](const Devices&) { return false; });
    }
    return group.witnesses()[2];
  }
};

/// In 100 s the vehicle turns by 600 degrees: one whole turn, and 240 degrees.
TEST(Group, OfHeadingsDoesNotDoubtAWitnessThatMissedATurn) {
  EXPECT_EQ(TurningHeadings{.silent_s = 0}.sail(300).test.suspicion(), 0);
  EXPECT_EQ(TurningHeadings{.silent_s = 100}.sail(300).test.suspicion(), 0);
}

TEST(Group, OfHeadingsTellsHowFarAWitnessIsOffAfterATurnThatItMissed) {
  TurningHeadings turning{.silent_s = 100, .away_rad = 25 * units::degree};
  const consistency::Test& course = turning.sail(203).test;
  EXPECT_TRUE(course.fired());
  EXPECT_NEAR(course.deviation(), 25 * units::degree, 0.5 * units::degree);
}

/// A witness that is unsure now, as the shaft of a hull that gains speed, pulls the median.
TEST(Group, DoesNotDoubtAnExactWitnessWhileTheOthersAreUnsure) {
  Group group;
  for (std::uint16_t k = 0; k < 3; ++k) group.add({k}, exact);
  Stamp at{std::chrono::seconds{1000}};
  for (std::uint64_t i = 0; i < 1000; ++i) {
    at += std::chrono::milliseconds{200};
    const double away = i > 900 ? 0.1 : 0;
    group.see(0, 3, i + 1);
    group.see(1, 3 + away, i + 1, away);
    group.see(2, 3 + away, i + 1, away);
    group.settle(at, 0.2, [](const Devices&) { return false; });
  }
  EXPECT_LT(group.witnesses()[0].test.suspicion(), 0.3);
}

}  // namespace
}  // namespace drydock::consistency

#include "drivers/diagnosis/judge.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/diagnosis/signs.hpp"

namespace drydock::diagnosis::judge_test {

struct TwoDevices : testing::Test, FindingListener {
  void on_finding(const Finding& finding) override { heard.push_back(finding); }
  void see(Sign sign, double at, std::uint16_t device = 0, double value = 1) {
    judge.see({.device = device,
               .sign = sign,
               .since = at_s(at - 1),
               .at = at_s(at),
               .value = value,
               .quantity = {},
               .unit = {}});
  }
  std::vector<Finding> heard;
  Judge judge{2, *this};
};

TEST_F(TwoDevices, HaveNoFindingWithoutASign) {
  judge.settle(at_s(0));
  EXPECT_TRUE(heard.empty());
  EXPECT_EQ(judge.open(0), nullptr);
}

TEST_F(TwoDevices, HaveFindingsOfTheirOwn) {
  see(Sign::gaps, 5, 1);
  judge.settle(at_s(5));
  EXPECT_EQ(judge.open(0), nullptr);
  ASSERT_NE(judge.open(1), nullptr);
  EXPECT_EQ(judge.open(1)->cause, Cause::drop);
  EXPECT_EQ(judge.open(1)->since, at_s(4));
  EXPECT_EQ(judge.open(1)->found, at_s(5));
}

TEST_F(TwoDevices, AreTakenBackWhenTheirSignIsOver) {
  see(Sign::gaps, 5);
  judge.settle(at_s(5));
  judge.settle(at_s(14.9));
  EXPECT_NE(judge.open(0), nullptr);
  judge.settle(at_s(15.1));
  EXPECT_EQ(judge.open(0), nullptr);
  ASSERT_EQ(heard.size(), 2U);
  EXPECT_EQ(heard[1].until, at_s(15.1));
}

TEST_F(TwoDevices, GetABetterWordForTheSameTrouble) {
  see(Sign::gaps, 5);
  judge.settle(at_s(5));
  see(Sign::rate_low, 7);
  judge.settle(at_s(7));
  ASSERT_EQ(heard.size(), 3U);
  EXPECT_EQ(heard[1].cause, Cause::drop);
  EXPECT_TRUE(heard[1].until);
  EXPECT_EQ(heard[2].cause, Cause::slow);
  EXPECT_EQ(heard[2].since, at_s(4)) << "the trouble began with the gaps";
  EXPECT_EQ(heard[2].evidence[0].sign, Sign::rate_low) << "what decided comes first";
}

TEST_F(TwoDevices, HaveANewTroubleWhereItBeganLongAfterTheFirstWasKnown) {
  see(Sign::offset, 5);
  judge.settle(at_s(5));
  for (int at = 6; at < 30; ++at) see(Sign::offset, at);
  see(Sign::stuck, 30);
  judge.settle(at_s(30));
  EXPECT_EQ(judge.open(0)->cause, Cause::stuck);
  EXPECT_EQ(judge.open(0)->since, at_s(29));
}

/// A damaged frame is remembered for 10 s, bytes without a frame for 1.5 s.
TEST_F(TwoDevices, HaveNoFindingOfWhatTheOneThatIsOverExplained) {
  see(Sign::bad_checksums, 5);
  see(Sign::nothing_decodes, 6);
  judge.settle(at_s(6));
  EXPECT_EQ(judge.open(0)->cause, Cause::wrong_baud);
  judge.settle(at_s(8));
  EXPECT_EQ(judge.open(0), nullptr);
}

TEST_F(TwoDevices, StayDamagedWhereFramesAreDamagedAfterTheBytesWithoutOnes) {
  see(Sign::nothing_decodes, 6);
  judge.settle(at_s(6));
  see(Sign::bad_checksums, 7);
  judge.settle(at_s(8));
  ASSERT_NE(judge.open(0), nullptr);
  EXPECT_EQ(judge.open(0)->cause, Cause::damaged);
}

TEST_F(TwoDevices, HaveLimitsOnTheSideOfTheirValues) {
  judge.see({.sign = Sign::offset,
             .since = at_s(4),
             .at = at_s(5),
             .value = -0.154,
             .limit = 0.029,
             .quantity = "speed over ground",
             .unit = "m/s"});
  judge.settle(at_s(5));
  EXPECT_EQ(judge.open(0)->evidence[0].limit, -0.029);
}

TEST_F(TwoDevices, HaveTheAdviceOfTheSignThatDecided) {
  judge.see({.sign = Sign::port_lost,
             .since = at_s(4),
             .at = at_s(5),
             .quantity = {},
             .unit = {},
             .advice = "look at host and port"});
  see(Sign::gaps, 5);
  judge.settle(at_s(5));
  EXPECT_EQ(judge.open(0)->advice, "look at host and port");
}

TEST_F(TwoDevices, AreDamagedWhereForeignBytesCostMessages) {
  see(Sign::foreign_bytes, 5);
  judge.settle(at_s(5));
  EXPECT_EQ(judge.open(0)->cause, Cause::foreign_bytes);
  see(Sign::gaps, 6);
  judge.settle(at_s(6));
  EXPECT_EQ(judge.open(0)->cause, Cause::damaged);
}

TEST_F(TwoDevices, AreSilentInALongPauseAndBunchedInShortOnes) {
  see(Sign::bunched, 5);
  see(Sign::silent, 5, 0, 0.9);
  judge.settle(at_s(5));
  EXPECT_EQ(judge.open(0)->cause, Cause::burst);
  see(Sign::silent, 9, 0, 4);
  judge.settle(at_s(9));
  EXPECT_EQ(judge.open(0)->cause, Cause::silent);
}

TEST_F(TwoDevices, AreSilentForAsLongAsTheSilenceLasted) {
  see(Sign::silent, 5, 0, 4);
  judge.settle(at_s(5));
  see(Sign::silent, 6, 0, 5);
  judge.settle(at_s(6));
  EXPECT_EQ(judge.open(0)->evidence[0].value, 5);
  judge.settle(at_s(9));
  ASSERT_EQ(heard.size(), 2U);
  EXPECT_EQ(heard[1].until, at_s(9));
  EXPECT_EQ(heard[1].evidence[0].value, 5);
}

TEST(Causes, HaveAMeaningAndAdvice) {
  for (const CauseFacts& facts : causes()) {
    EXPECT_FALSE(facts.meaning.empty()) << facts.name;
    EXPECT_FALSE(facts.advice.empty()) << facts.name;
  }
}

TEST(SignNames, AreThereForEachSign) {
  for (unsigned i = 0; i < diagnosis::sign_count; ++i)
    EXPECT_FALSE(to_string(static_cast<Sign>(i)).empty()) << i;
}

}  // namespace drydock::diagnosis::judge_test

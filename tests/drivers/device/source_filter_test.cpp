// Decides which frames come from our sensor: by address, or by NAME once it was heard (SAE
// J1939-81).
#include "drivers/device/bus/source_filter.hpp"

#include <gtest/gtest.h>

namespace source_filter_test {
namespace {

using namespace std::chrono_literals;
using drydock::device::SourceFilter;
const drydock::measurement::Stamp now{};

TEST(SourceFilter, AConfiguredAddressIsTheOnlyOne) {
  SourceFilter filter(35);
  EXPECT_TRUE(filter.accepts(35, now));
  EXPECT_FALSE(filter.accepts(36, now + 1h)) << "however long it is silent";
}

TEST(SourceFilter, WithoutOneTheFirstHeardIsOursUntilItIsSilentForTenSeconds) {
  SourceFilter filter(0);
  EXPECT_TRUE(filter.accepts(40, now));
  EXPECT_FALSE(filter.accepts(41, now + 10s));
  EXPECT_TRUE(filter.accepts(41, now + 11s));
}

TEST(SourceFilter, ASensorThatLostItsAddressIsFollowedToItsNextOne) {
  for (const std::uint8_t configured : {0, 35}) {
    SourceFilter filter(configured);
    filter.accepts(35, now);
    filter.claimed(35, 0xABC, now);  // our sensor boots
    filter.accepts(35, now);
    filter.claimed(35, 0x001, now);  // a stronger NAME takes its address
    EXPECT_FALSE(filter.accepts(35, now)) << "the thief is not our sensor";
    EXPECT_EQ(filter.source(), std::nullopt);
    filter.claimed(128, 0xABC, now);
    EXPECT_TRUE(filter.accepts(128, now));
    EXPECT_FALSE(filter.accepts(35, now));
  }
}

TEST(SourceFilter, ATheftThatNobodyHeardEndsWithTheSensorsNextClaim) {
  SourceFilter filter(35);
  filter.claimed(35, 0xABC, now);
  filter.accepts(35, now + 1s);
  EXPECT_FALSE(filter.accepts(128, now + 2h)) << "it moved while the controller was bus-off";
  filter.claimed(128, 0xABC, now + 2h);  // the answer to a request
  EXPECT_TRUE(filter.accepts(128, now + 2h));
}

TEST(SourceFilter, AnotherUnitAtTheConfiguredAddressIsTakenWhenTheFirstIsSilentForThirtySeconds) {
  SourceFilter filter(35);
  filter.claimed(35, 0xABC, now);
  filter.accepts(35, now);
  filter.claimed(35, 0xDEF, now + 5s);  // a spare part, or a node that steals the address
  EXPECT_FALSE(filter.accepts(35, now + 30s));
  EXPECT_FALSE(filter.accepts(36, now + 31s));
  EXPECT_TRUE(filter.accepts(35, now + 31s));
  filter.claimed(35, 0xDEF, now + 32s);
  EXPECT_TRUE(filter.accepts(35, now + 32s));
  filter.claimed(35, 0x001, now + 33s);
  filter.claimed(129, 0xDEF, now + 34s);
  EXPECT_TRUE(filter.accepts(129, now + 34s)) << "its NAME is the spare's now";
}

TEST(SourceFilter, WithoutAnAddressAnotherUnitIsTakenAfterThirtySecondsToo) {
  SourceFilter filter(0);
  filter.accepts(40, now);
  filter.claimed(40, 0xABC, now);
  EXPECT_FALSE(filter.accepts(41, now + 30s));
  EXPECT_TRUE(filter.accepts(41, now + 31s));
}

TEST(SourceFilter, AClaimThatWasDamagedBeforeTheSensorSpokeIsPutRightByTheNext) {
  SourceFilter filter(35);
  filter.claimed(35, 0xABD, now);
  filter.claimed(35, 0xABC, now + 1ms);  // the answer to a request
  EXPECT_TRUE(filter.accepts(35, now + 1s));
  filter.claimed(35, 0x001, now + 2s);
  filter.claimed(128, 0xABC, now + 3s);
  EXPECT_TRUE(filter.accepts(128, now + 3s));
}

TEST(SourceFilter, ASensorWhoseAddressWasTakenWhileItWasSilentIsFollowedByTheNameItHadBefore) {
  SourceFilter filter(128);
  filter.claimed(128, 0xABC, now);
  filter.accepts(128, now);
  filter.claimed(128, 0x001, now + 1min);  // its controller was cut off, and another node took 128
  EXPECT_TRUE(filter.accepts(128, now + 8min)) << "it is back, and knows nothing of that";
  filter.claimed(128, 0xABC, now + 9min);  // the answers to a request: both hold 128
  filter.claimed(128, 0x001, now + 9min);
  filter.claimed(129, 0xABC, now + 9min);  // the weaker NAME gives way
  EXPECT_TRUE(filter.accepts(129, now + 9min));
  EXPECT_FALSE(filter.accepts(128, now + 9min));
}

TEST(SourceFilter, ASpareUnitThatHasSpokenIsNotLeftForTheFirstOne) {
  SourceFilter filter(35);
  filter.claimed(35, 0xABC, now);
  filter.accepts(35, now);
  filter.accepts(35, now + 1min);
  filter.claimed(35, 0xDEF, now + 2min);
  EXPECT_TRUE(filter.accepts(35, now + 3min));
  filter.claimed(35, 0xDEF, now + 4min);
  EXPECT_TRUE(filter.accepts(35, now + 4min));
  filter.claimed(36, 0xABC, now + 5min);
  EXPECT_TRUE(filter.accepts(35, now + 5min));
  EXPECT_FALSE(filter.accepts(36, now + 5min));
}

TEST(SourceFilter, ANameThatWasClaimedBeforeTheSensorWasChosenIsFollowed) {
  for (const bool thief_first : {false, true}) {
    SourceFilter filter(0);
    filter.claimed(40, 0xABC, now);
    filter.claimed(41, 0xDEF, now);  // another node of the bus
    EXPECT_TRUE(filter.accepts(40, now + 1s));
    if (thief_first) filter.claimed(40, 0x001, now + 2s);
    filter.claimed(50, 0xABC, now + 2s);
    if (!thief_first) filter.claimed(40, 0x001, now + 2s);
    EXPECT_FALSE(filter.accepts(40, now + 3s));
    EXPECT_FALSE(filter.accepts(41, now + 3s));
    EXPECT_TRUE(filter.accepts(50, now + 3s));
  }
}

TEST(SourceFilter, ANodeThatMovedBeforeTheSensorWasChosenHasLeftItsAddress) {
  SourceFilter filter(0);
  filter.claimed(40, 0xABC, now);
  filter.claimed(50, 0xABC, now);
  EXPECT_TRUE(filter.accepts(40, now + 1s)) << "a unit whose NAME nobody heard";
  filter.claimed(51, 0xABC, now + 2s);
  EXPECT_TRUE(filter.accepts(40, now + 3s)) << "the move of another";
}

TEST(SourceFilter, TheSuccessorOfASilentSensorHasTheNameThatItClaimedBefore) {
  SourceFilter filter(0);
  filter.claimed(40, 0xABC, now);
  filter.claimed(41, 0xDEF, now);
  EXPECT_TRUE(filter.accepts(40, now));
  EXPECT_TRUE(filter.accepts(41, now + 31s));
  filter.claimed(41, 0x001, now + 32s);
  filter.claimed(60, 0xDEF, now + 32s);
  EXPECT_FALSE(filter.accepts(41, now + 33s));
  EXPECT_TRUE(filter.accepts(60, now + 33s));
}

TEST(SourceFilter, AThiefThatRepeatsItsClaimIsNotTakenForTheSensorThatComesBack) {
  SourceFilter filter(0);
  filter.claimed(128, 0xABC, now);
  filter.accepts(128, now);
  for (int i = 1; i < 40; ++i) filter.claimed(128, 0x001, now + i * 10s);  // it answers requests
  EXPECT_TRUE(filter.accepts(128, now + 8min));
  filter.claimed(129, 0xABC, now + 9min);
  EXPECT_TRUE(filter.accepts(129, now + 9min));
  EXPECT_FALSE(filter.accepts(128, now + 9min));
}

// A thief's claim stays in the table. The sensor then boots at that address while a bus that is off
// hides its claim, so it passes for the thief until it claims again.
TEST(SourceFilter, ASensorWhoseClaimWasNotHeardIsKnownByItsNextOneAtTheSameAddress) {
  constexpr std::uint64_t sensor = 0xABC, thief = 0x001;
  SourceFilter filter(128);
  filter.claimed(128, sensor, now);
  filter.accepts(128, now);
  filter.claimed(128, thief, now + 1s);
  filter.claimed(129, sensor, now + 1s);
  ASSERT_TRUE(filter.accepts(129, now + 2s));
  ASSERT_TRUE(filter.accepts(128, now + 60s)) << "silent for longer than 30 s";
  filter.claimed(128, sensor, now + 70s);  // somebody asks all for their NAMEs
  EXPECT_TRUE(filter.accepts(128, now + 71s));
  filter.claimed(128, thief, now + 100s);
  EXPECT_FALSE(filter.accepts(128, now + 101s)) << "a second theft";
  filter.claimed(130, sensor, now + 101s);
  EXPECT_TRUE(filter.accepts(130, now + 102s));
}

TEST(SourceFilter, OneThatCanClaimNoAddressIsHeardNoMore) {
  SourceFilter filter(35);
  filter.claimed(35, 0xABC, now);
  filter.claimed(254, 0xABC, now);
  EXPECT_FALSE(filter.accepts(35, now));
}

TEST(SourceFilter, ClaimsOfOthersAreNoMatterOfOurs) {
  SourceFilter filter(35);
  filter.claimed(35, 0xABC, now);
  filter.claimed(36, 0x001, now);
  EXPECT_TRUE(filter.accepts(35, now));
}

}  // namespace
}  // namespace source_filter_test

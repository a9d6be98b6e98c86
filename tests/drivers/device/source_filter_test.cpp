// Whose frames are our sensor's: by address, by NAME once it was heard (SAE J1939-81).
#include "drivers/device/source_filter.hpp"

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
    filter.claimed(35, 0xABC);  // our sensor's boot
    filter.claimed(35, 0x001);  // a stronger NAME takes its address
    EXPECT_FALSE(filter.accepts(35, now)) << "the thief is not our sensor";
    EXPECT_EQ(filter.source(), std::nullopt);
    filter.claimed(128, 0xABC);
    EXPECT_TRUE(filter.accepts(128, now));
    EXPECT_FALSE(filter.accepts(35, now));
  }
}

TEST(SourceFilter, OneThatCanClaimNoAddressIsHeardNoMore) {
  SourceFilter filter(35);
  filter.claimed(35, 0xABC);
  filter.claimed(254, 0xABC);
  EXPECT_FALSE(filter.accepts(35, now));
}

TEST(SourceFilter, ClaimsOfOthersAreNoMatterOfOurs) {
  SourceFilter filter(35);
  filter.claimed(35, 0xABC);
  filter.claimed(36, 0x001);
  EXPECT_TRUE(filter.accepts(35, now));
}

}  // namespace
}  // namespace source_filter_test

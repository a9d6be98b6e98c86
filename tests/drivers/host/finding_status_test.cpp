#include "drivers/host/finding_status.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace drydock::host {
namespace finding_status_test {

using diagnosis::Cause;
using measurement::Stamp;
using testing::Contains;
using testing::Pair;
using testing::SizeIs;

/// Damaged frames since 2026-07-01 08:00:00 UTC, known half a second later.
constexpr std::int64_t since_utc_s = 1'782'892'800;

diagnosis::Finding damaged() {
  const Stamp since{std::chrono::seconds{since_utc_s}};
  diagnosis::Finding finding{.device = 1,
                             .cause = Cause::damaged,
                             .since = since,
                             .found = since + std::chrono::milliseconds{500},
                             .until = {},
                             .confidence = 0.9,
                             .evidence = {},
                             .advice = {}};
  finding.evidence.push_back({diagnosis::Sign::bad_checksums, 12, 0, "damaged frames", ""});
  finding.evidence.push_back({diagnosis::Sign::rate_low, 2.5, 4.5, "rate", "Hz"});
  return finding;
}

FindingStatuses statuses() { return FindingStatuses(std::vector<std::string>{"imu", "dvl"}); }

TEST(FindingStatus, HasDeviceAndCauseInItsNameAndTheEvidenceAsValues) {
  auto all = statuses();
  const auto status = all.take(damaged());
  EXPECT_EQ(status.name, "dvl/damaged");
  EXPECT_EQ(status.hardware_id, "dvl");
  EXPECT_EQ(status.level, bus::Level::warn);
  EXPECT_EQ(status.message,
            "frames arrive damaged: 12 damaged frames (at most 0), rate 2.5 Hz (at least 4.5 Hz)");
  EXPECT_THAT(status.values, Contains(Pair("since_s", "1782892800")));
  EXPECT_THAT(status.values, Contains(Pair("evidence_1_value", "12")));
  EXPECT_THAT(status.values, Contains(Pair("evidence_2_limit", "4.5")));
  EXPECT_THAT(status.values, Contains(Pair("evidence_2_unit", "Hz")));
}

TEST(FindingStatus, OfADeviceWithoutValuesIsAnError) {
  auto silent = damaged();
  silent.cause = Cause::silent;
  auto all = statuses();
  EXPECT_EQ(all.take(silent).level, bus::Level::error);
}

TEST(FindingStatus, IsRepeatedWhileItLastsAndOkOnceWhenItIsOver) {
  auto all = statuses();
  all.take(damaged());
  EXPECT_THAT(all.open(), SizeIs(1));
  auto over = damaged();
  over.until = over.since + std::chrono::seconds{7};
  const auto status = all.take(over);
  EXPECT_EQ(status.level, bus::Level::ok);
  EXPECT_EQ(status.message, "no longer damaged");
  EXPECT_THAT(status.values, Contains(Pair("until_s", "1782892807.000000")));
  EXPECT_THAT(all.open(), SizeIs(0));
}

TEST(FindingStatus, ComesBackFromTheBusAsItWas) {
  auto all = statuses();
  const auto back = finding_of(all.take(damaged()));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->device, "dvl");
  EXPECT_EQ(back->cause, "damaged");
  EXPECT_FALSE(back->severe);
  EXPECT_EQ(back->since_s, since_utc_s);
  EXPECT_EQ(back->found_s, since_utc_s + 0.5);
  EXPECT_FALSE(back->until_s);
  ASSERT_THAT(back->evidence, SizeIs(2));
  EXPECT_EQ(back->evidence[1].quantity, "rate");
  EXPECT_EQ(back->evidence[1].limit, 4.5);
  EXPECT_THAT(back->advice, testing::StartsWith("look at the cable"));
}

TEST(FindingStatus, TheHealthOfADeviceAndForeignTextAreNoFindings) {
  bus::DeviceStatus health;
  health.name = "dvl";
  health.message = "streaming";
  EXPECT_FALSE(finding_of(health));
  bus::DeviceStatus foreign;
  foreign.name = "cpu/load";
  EXPECT_FALSE(finding_of(foreign));
  const auto odd = finding_of({.level = bus::Level::warn,
                               .name = "dvl/bias",
                               .message = "",
                               .hardware_id = "",
                               .values = {{"since_s", "nan"}, {"until_s", "soon"}}});
  ASSERT_TRUE(odd);
  EXPECT_EQ(odd->since_s, 0);
  EXPECT_FALSE(odd->until_s);
}

}  // namespace finding_status_test
}  // namespace drydock::host

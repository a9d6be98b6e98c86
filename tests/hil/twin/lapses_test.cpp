#include <gmock/gmock.h>

#include <limits>

#include "hil/twin/lapse_text.hpp"

namespace drydock::twin {
namespace {

using rig_config::DeviceKind;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr measurement::Stamp start = measurement::stamp_from_ns(1'000'000'000'000'000'000);

/// A sample each second; `without` has no value.
std::vector<Error> samples(const std::vector<int>& seconds, const std::vector<int>& without) {
  std::vector<Error> errors;
  for (const int s : seconds) {
    errors.push_back({.valid_at = start + std::chrono::seconds{s}});
    if (std::ranges::count(without, s) > 0)
      errors.back().of[0].setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  return errors;
}

TEST(Lapses, ALongSilenceIsAFaultHalfAStepFromItsSamples) {
  const auto errors = samples({0, 1, 2, 3, 4, 10, 11, 12, 14, 15}, {});
  const auto statistics = statistics_of(errors, DeviceKind::dvl);
  EXPECT_EQ(statistics.timing.outages, 2u);
  ASSERT_EQ(statistics.timing.long_gaps.size(), 1u);
  EXPECT_EQ(statistics.timing.lost_in_long_gaps, 5u);
  const auto text = lapse_text(statistics, "dvl", DeviceKind::dvl, start);
  EXPECT_THAT(text, HasSubstr("fault = \"drop\"\nprobability = 1\nstart_s = 4.500\nfor_s = 5.000"));
}

TEST(Lapses, ThreePingsWithoutBottomLockAreOne) {
  const auto errors = samples({0, 1, 2, 3, 4, 5, 6, 7, 8}, {1, 4, 5, 6});
  const auto statistics = statistics_of(errors, DeviceKind::dvl);
  EXPECT_EQ(statistics.empty, 4u);
  EXPECT_EQ(lapse_text(statistics, "dvl", DeviceKind::dvl, start),
            "\n[[fault]]\ndevice = \"dvl\"\nfault = \"bottom-lost\"\nstart_s = 3.500\nfor_s = "
            "3.000\n");
  EXPECT_THAT(lapse_text(statistics, "log", DeviceKind::emlog, start), IsEmpty());
}

}  // namespace
}  // namespace drydock::twin

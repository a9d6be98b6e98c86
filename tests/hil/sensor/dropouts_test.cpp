#include "hil/sensor/dropouts.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace drydock::sensor {
namespace dropouts_test {

TEST(Dropouts, NoneConfiguredNoneLost) {
  Dropouts dropouts({}, 1, "dvl");
  for (int i = 0; i < 1000; ++i) EXPECT_FALSE(dropouts.next_is_lost());
}

TEST(Dropouts, ComeInBurstsOfTheGivenMeanLength) {
  constexpr double begin = 0.02, mean = 5;
  Dropouts dropouts({begin, mean}, 1, "dvl");
  constexpr int n = 400'000;
  int lost = 0, outages = 0;
  bool out = false;
  for (int i = 0; i < n; ++i) {
    const bool now = dropouts.next_is_lost();
    lost += now;
    outages += now && !out;
    out = now;
  }
  // Two-state chain: a share p L / (1 + p L) of the samples is lost. Lengths are geometric with
  // variance L (L - 1).
  const double expected = begin * mean / (1 + begin * mean);
  EXPECT_NEAR(static_cast<double>(outages) / (n - lost), begin, 4 * std::sqrt(begin / n));
  EXPECT_NEAR(static_cast<double>(lost) / outages, mean,
              4 * std::sqrt(mean * (mean - 1) / outages));
  EXPECT_NEAR(static_cast<double>(lost) / n, expected, 0.03 * expected);
}

TEST(Dropouts, OfMeanLengthOneNeverLastLonger) {
  Dropouts dropouts({0.3, 1}, 1, "dvl");
  bool last = false;
  for (int i = 0; i < 1000; ++i) {
    const bool now = dropouts.next_is_lost();
    EXPECT_FALSE(now && last);  // an outage of one sample ends at the next
    last = now;
  }
}

}  // namespace dropouts_test
}  // namespace drydock::sensor

#include "hil/proxy/latency.hpp"

#include <gtest/gtest.h>

namespace latency_test {

using namespace drydock;

TEST(Latency, ItsPercentilesAreWithinAnEighthOfAnOctave) {
  proxy::Latency latency;
  EXPECT_EQ(latency.percentile(0.99).count(), 0);
  for (int us = 1; us <= 1000; ++us) latency.add(std::chrono::microseconds{us});
  EXPECT_NEAR(static_cast<double>(latency.percentile(0.5).count()), 500e3, 500e3 * 0.1);
  EXPECT_NEAR(static_cast<double>(latency.percentile(0.99).count()), 990e3, 990e3 * 0.1);
}

}  // namespace latency_test

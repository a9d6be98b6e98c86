#include <gtest/gtest.h>

#include "estimators/roll/all_satellites.hpp"
#include "estimators/roll/peak_filter.hpp"
#include "tests/estimators/pipeline/counting_new.hpp"
#include "tests/estimators/roll/flight.hpp"

namespace drydock::roll::no_allocation_test {
namespace {

TEST(Roll, AllocatesNothingPerSampleOrEpoch) {
  AllSatellites all({});
  PeakFilter peaks({});
  test::Flight flight;
  flight.noise = 0.1;
  const std::size_t before = pipeline::test::allocations();
  for (int k = 1; k <= 2000; ++k) {
    all.predict(flight.rate_radps, 0.01);
    peaks.predict(flight.rate_radps, 0.01);
    if (k % 10 != 0) continue;
    const Epoch epoch{.signals = flight.at(0.01 * k), .path = flight.path()};
    all.update(epoch);
    peaks.update(epoch);
  }
  EXPECT_EQ(pipeline::test::allocations(), before);
  EXPECT_TRUE(all.running() && peaks.running());
}

}  // namespace
}  // namespace drydock::roll::no_allocation_test

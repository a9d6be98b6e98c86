#include "hil/validity/pairing.hpp"

#include <gtest/gtest.h>

namespace drydock::validity {
namespace pairing_test {

std::vector<Stamp> at_ms(const std::vector<int>& times) {
  std::vector<Stamp> stamps;
  for (const int t : times)
    stamps.push_back(measurement::stamp_from_ns(std::int64_t{t} * 1'000'000));
  return stamps;
}

using Pairs = std::vector<std::optional<std::size_t>>;

TEST(Pairing, EachMeasurementTakesTheSampleItWasMadeOf) {
  EXPECT_EQ(pair(at_ms({101, 202, 299}), at_ms({100, 200, 300, 400})), (Pairs{0, 1, 2}));
}

TEST(Pairing, SamplesThatWereLostAreTakenByNone) {
  EXPECT_EQ(
      pair(at_ms({101, 303, 404, 901}), at_ms({0, 100, 200, 300, 400, 500, 600, 700, 800, 900})),
      (Pairs{1, 3, 4, 9}));
}

TEST(Pairing, TwoThatAStallBroughtAtOnceAreTwoSamplesWithTheirErrors) {
  // The host slept from 195 to 309, so the sample of 200 looks like that of 300.
  EXPECT_EQ(pair(at_ms({101, 299, 301, 401}), at_ms({100, 200, 300, 400})), (Pairs{0, 1, 2, 3}));
}

TEST(Pairing, WhatCameTwiceIsLeftAlone) {
  const auto pairs = pair(at_ms({101, 102, 202}), at_ms({100, 200}));
  EXPECT_EQ(std::count(pairs.begin(), pairs.end(), std::nullopt), 1);
  EXPECT_EQ(pairs[2], 1U);
}

TEST(Pairing, OfNothingThereIsNothing) {
  EXPECT_EQ(pair(at_ms({}), at_ms({1})), Pairs{});
  EXPECT_EQ(pair(at_ms({1}), at_ms({})), Pairs{std::nullopt});
}

/// Measurements far from every sample on both sides, and gaps longer than the search reaches.
TEST(Pairing, LongGapsOnEitherSideAreCrossed) {
  std::vector<int> all, heard;
  for (int i = 0; i < 1000; ++i) all.push_back(10 * i);
  for (int i = 0; i < 1000; ++i)
    if (i < 100 || i > 700) heard.push_back(10 * i + 1);
  const auto pairs = pair(at_ms(heard), at_ms(all));
  for (std::size_t i = 0; i < heard.size(); ++i)
    EXPECT_EQ(pairs[i], static_cast<std::size_t>(heard[i] / 10));
  const auto backwards = pair(at_ms(all), at_ms(heard));
  EXPECT_EQ(std::count(backwards.begin(), backwards.end(), std::nullopt), 601);
}

}  // namespace pairing_test
}  // namespace drydock::validity

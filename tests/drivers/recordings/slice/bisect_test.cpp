#include "drivers/recordings/slice/bisect.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace drydock::slice {
namespace bisect_test {

using record::Selection;
using record::Stamp;

std::vector<Stamp> times(int count) {
  std::vector<Stamp> all;
  for (int i = 0; i < count; ++i) all.emplace_back(std::chrono::seconds{i});
  return all;
}

bool holds(const Selection& part, int second) {
  return part.holds(Stamp{std::chrono::seconds{second}}, Stamp{});
}

bool has(const Selection& part, const std::string& link) {
  return part.only.empty() ||
         std::find(part.only.begin(), part.only.end(), link) != part.only.end();
}

TEST(Bisect, FindsTheTwoEventsOfOneLinkThatAFailureNeeds) {
  const auto found = bisect(times(3600), {"gps", "dvl", "can0"}, [](const Selection& part) {
    return holds(part, 1234) && holds(part, 1250) && has(part, "dvl");
  });
  EXPECT_TRUE(found.fails_at_all);
  EXPECT_EQ(found.part.from, std::chrono::seconds{1234});
  EXPECT_EQ(found.part.to, std::chrono::seconds{1251});
  EXPECT_EQ(found.part.only, (std::vector<std::string>{"dvl"}));
  EXPECT_EQ(found.events, 17U);
  EXPECT_LE(found.runs, 1 + 12 + 12 + 3);
}

TEST(Bisect, WithoutAFailureOneRunIsEnough) {
  const auto found = bisect(times(100), {"gps"}, [](const Selection&) { return false; });
  EXPECT_FALSE(found.fails_at_all);
  EXPECT_EQ(found.runs, 1);
}

TEST(Bisect, BrokenOffItKeepsTheSmallestSoFar) {
  int runs = 0;
  const auto found = bisect(times(100), {"gps"}, [&](const Selection&) -> std::optional<bool> {
    return ++runs < 4 ? std::optional(true) : std::nullopt;
  });
  EXPECT_TRUE(found.broken_off);
  EXPECT_EQ(found.runs, 4);
  EXPECT_LT(found.events, 50U);
}

}  // namespace bisect_test
}  // namespace drydock::slice

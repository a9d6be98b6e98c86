#include "estimators/consistency/parity.hpp"

#include <gtest/gtest.h>

namespace drydock::consistency {
namespace {

Stamp at_s(double seconds) { return Stamp{} + measurement::from_seconds(seconds); }

/// A residual that is 0 for 20 s and then ten floors.
consistency::Test fired() {
  consistency::Test test(TestFacts{.floor = 0.1});
  for (int i = 0; i < 150; ++i) test.take({.value = i < 100 ? 0. : 1.}, at_s(100 + 0.2 * i));
  return test;
}

// The log's own samples are wrong. Of DVL and pressure sensor, whose depths differ, the speeds that
// it contradicts say nothing.
TEST(Parity, CountsNoTestThatAnotherDeviceExplains) {
  enum : std::uint16_t { dvl, log, depth };
  Doubts doubts({{.kind = measurement::Kind::dvl},
                 {.kind = measurement::Kind::emlog},
                 {.kind = measurement::Kind::depth}});
  const auto speed = fired(), way_down = fired();
  const Accusations all{{{log, dvl}, &speed}, {{depth, dvl}, &way_down}};
  const auto named = [&] {
    Parity::Names names = Parity{}.name(all, doubts, at_s(130));
    return names.size() == 1 ? std::optional(names.front().device) : std::nullopt;
  };
  doubts.begin(at_s(130));
  EXPECT_EQ(named(), dvl) << "it alone stands in both tests";
  doubts.note_own(log, at_s(120), at_s(129));
  doubts.begin(at_s(130));
  EXPECT_EQ(named(), depth);
}

}  // namespace
}  // namespace drydock::consistency

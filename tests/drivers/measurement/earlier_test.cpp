#include "drivers/measurement/earlier.hpp"

#include <gtest/gtest.h>

namespace earlier_test {

using drydock::measurement::earlier;
using drydock::measurement::stamp_from_ns;

constexpr std::optional<drydock::measurement::Stamp> never, first = stamp_from_ns(1),
                                                            second = stamp_from_ns(2);

TEST(Earlier, IsTheFirstOfTwoDeadlinesInEitherOrder) {
  EXPECT_EQ(earlier(first, second), first);
  EXPECT_EQ(earlier(second, first), first);
}

TEST(Earlier, IsTheOnlyDeadlineIfTheOtherNeverComes) {
  EXPECT_EQ(earlier(second, never), second);
  EXPECT_EQ(earlier(never, second), second);
}

TEST(Earlier, NeverComesIfNeitherDoes) { EXPECT_EQ(earlier(never, never), never); }

}  // namespace earlier_test

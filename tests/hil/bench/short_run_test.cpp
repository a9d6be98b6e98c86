#include "hil/bench/short_run.hpp"

#include <gtest/gtest.h>

namespace drydock::bench {
namespace short_run_test {

TEST(ShortRun, IsToldInSecondsWithoutAnExponent) {
  summary::Summary summary;
  summary.duration_s = 2651;
  summary.interrupted = true;
  EXPECT_EQ(short_run_in_words(summary, 3.6e6),
            "a run of 2651.0 s, not of 3600000 s: a signal ended it");
  summary.interrupted = false;
  EXPECT_EQ(short_run_in_words(summary, 3600.5), "a run of 2651.0 s, not of 3600.5 s");
}

TEST(ShortRun, OfItsWholeTimeIsNone) {
  summary::Summary summary;
  summary.duration_s = 100;
  EXPECT_FALSE(verdict_of_short_run(summary, 100));
  EXPECT_EQ(verdict_of_short_run(summary, 3.6e6)->expected, "3600000");
}

}  // namespace short_run_test
}  // namespace drydock::bench

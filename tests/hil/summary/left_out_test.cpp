#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hil/summary/summary.hpp"

namespace drydock::summary::left_out_test {

using testing::HasSubstr;
using testing::Not;

TEST(LeftOut, GoodValuesThatNoMeasurementHoldsAreCountedInTheTableAndAreNoError) {
  Summary summary;
  summary.devices.emplace_back();
  summary.devices[0].name = "dvl";
  summary.devices[0].refused = 412;
  summary.devices[0].left_out = "no measurement holds the DVL's dead reckoning";
  const auto table = to_text(summary);
  EXPECT_THAT(table, HasSubstr("\n           left out: 412 values, such as: no measurement holds "
                               "the DVL's dead reckoning\n"));
  EXPECT_THAT(table, Not(HasSubstr("last error")));
}

}  // namespace drydock::summary::left_out_test

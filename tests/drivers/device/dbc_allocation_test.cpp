#include "drivers/wire/dbc/catalogue.hpp"
#include "drivers/wire/dbc/plan.hpp"
#include "drivers/wire/dbc/reader.hpp"
#include "tests/drivers/device/allocation_count.hpp"
#include "tests/drivers/device/support.hpp"

namespace drydock::device::test {
namespace dbc_allocation_test {

namespace dbc = wire::dbc;

TEST(Allocation, NoneByFramesOfADbcFile) {
  const auto reading = dbc::read(
      "BO_ 256 status: 8 unit\n SG_ page M : 0|4@1+ (1,0) [0|0] \"\" host\n"
      " SG_ temperature m0 : 10|11@0- (0.1,20) [0|0] \"degC\" host\n"
      " SG_ voltage m1 : 8|12@1+ (0.01,0) [0|0] \"V\" host\n");
  const dbc::Catalogue catalogue(reading.database);
  const dbc::Plan plan(reading.database.messages.at(0));
  std::vector<dbc::Value> values(plan.size());
  auto frame = can_frame(0x100, false, {0x01, 0x60, 0x09, 0x00});
  const AllocationCount count;
  double volts = 0;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(catalogue.find(frame));
    plan.decode(frame.payload(), values);
    volts = values[2].physical;
    plan.encode(values, {frame.data.data(), frame.size});
  }
  EXPECT_EQ(count.so_far(), 0U);
  EXPECT_NEAR(volts, 24, 1e-9);
}

}  // namespace dbc_allocation_test
}  // namespace drydock::device::test

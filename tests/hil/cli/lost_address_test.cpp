// A J1939 sensor loses its address while its driver hears nothing: once the bus is back, it is
// found at its new address by its NAME.
#include <gmock/gmock.h>

#include <algorithm>

#include "hil/cli/run.hpp"
#include "rig_config/load.hpp"

namespace lost_address_test {
namespace {

using namespace drydock;

cli::Summary run_soak_rig(const std::string& faults, double duration_s) {
  auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/soak.toml").value();
  rig.faults = rig_config::load_faults_text(faults, "test").value();
  EXPECT_THAT(rig_config::check_faults_of(rig), testing::IsEmpty());
  cli::RunOptions options;
  options.duration_s = duration_s;
  options.quiet = true;
  return cli::run_lockstep(rig, options);
}

const cli::DeviceSummary& device(const cli::Summary& summary, std::string_view name) {
  return *std::ranges::find(summary.devices, name, &cli::DeviceSummary::name);
}

class EachSensor : public testing::TestWithParam<const char*> {};

TEST_P(EachSensor, IsFoundAgainWhoseAddressWasTakenWhileTheDriverWasBusOff) {
  const std::string name = GetParam();
  const std::string other = name == "depth" ? "actuators" : "depth";
  const auto summary =
      run_soak_rig("[[fault]]\ndevice = \"" + other +
                       "\"\nfault = \"bus-off\"\nstart_s = 20\nfor_s = 10\n"
                       "[[fault]]\ndevice = \"" +
                       name + "\"\nfault = \"address-stolen\"\nstart_s = 25\nfor_s = 60\n",
                   60);
  EXPECT_EQ(device(summary, name).state, "streaming") << device(summary, name).last_error;
  // Silent from 20 s until it is asked for, 10 s after it was last heard, and the 250 ms after a
  // claim.
  const double rate_hz = name == "actuators" ? 2 * 4 : 2;
  EXPECT_NEAR(static_cast<double>(device(summary, name).messages), rate_hz * (60 - 10.5),
              rate_hz * 1.5);
}

INSTANTIATE_TEST_SUITE_P(J1939, EachSensor, testing::Values("depth", "actuators", "openimu"));

TEST(BusOff, EndsWhenTheLastFaultThatKeepsTheControllerOffHasCleared) {
  const auto summary = run_soak_rig(
      "[[fault]]\ndevice = \"depth\"\nfault = \"bus-off\"\nstart_s = 20\nfor_s = 30\n"
      "[[fault]]\ndevice = \"actuators\"\nfault = \"bus-off\"\nstart_s = 25\nfor_s = 5\n",
      60);
  for (const char* name : {"depth", "openimu"})  // 2 Hz, without 20 s to 50 s
    EXPECT_NEAR(static_cast<double>(device(summary, name).messages), 60, 3) << name;
}

}  // namespace
}  // namespace lost_address_test

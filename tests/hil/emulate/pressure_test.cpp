#include <gtest/gtest.h>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/canopen/canopen.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {
namespace {

using rig_config::DeviceKind;

/// The TPDO1 frames of a transmitter after it is started.
std::vector<wire::CanFrame> values_of(const rig_config::DeviceConfig& config,
                                      const motion::Trajectory& trajectory) {
  const auto made = make_emulated_device(config, trajectory, 1).value();
  Recorder sent;
  sent.run(*made, at_s(0.1));
  made->receive(wire::canopen::encode(wire::canopen::Nmt{wire::canopen::NmtCommand::start, 0}),
                sent.now, sent);
  sent.run(*made, at_s(2));
  std::vector<wire::CanFrame> values;
  for (const auto& f : sent.frames) {
    if (f.frame.id == 0x181) values.push_back(f.frame);
  }
  return values;
}

// 20 m depth at 47.123456 deg; Somigliana: 9.808118 m/s2.
constexpr double column_pa = 1025 * 9.808118 * 20;

TEST(EmulatedPressure, SaysTheWaterColumnAsIntegerWithStatus) {
  const Frozen trajectory(under_way());
  auto config = device(DeviceKind::depth, "cia404-pressure", 2);
  config.pressure.unit = "mbar";
  config.pressure.decimals = 2;
  const auto values = values_of(config, trajectory);
  ASSERT_GE(values.size(), 3U);
  EXPECT_EQ(values[0].size, 5);
  EXPECT_NEAR(wire::load_le<std::int32_t>(values[0].payload(), 0), 101325 + column_pa, 1);
  EXPECT_EQ(values[0].data[4], 0);
}

TEST(EmulatedPressure, AGaugeSaysTheWaterAlone) {
  const Frozen trajectory(under_way());
  auto config = device(DeviceKind::depth, "cia404-pressure", 2);
  config.pressure.gauge = true;
  config.pressure.format = "real32";
  config.pressure.unit = "bar";
  const auto values = values_of(config, trajectory);
  ASSERT_GE(values.size(), 3U);
  EXPECT_EQ(values[0].size, 4);
  EXPECT_NEAR(wire::load_le<float>(values[0].payload(), 0), column_pa / 1e5, 1e-5);
}

}  // namespace
}  // namespace drydock::emulate

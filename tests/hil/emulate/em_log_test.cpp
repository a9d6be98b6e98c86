#include <gtest/gtest.h>

#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {
namespace {

using rig_config::DeviceKind;

TEST(EmulatedEmLog, SaysSpeedThroughTheWaterInKnots) {
  const Frozen trajectory(under_way());
  const auto sent = record(device(DeviceKind::emlog, "nmea0183"), trajectory, 0);
  ASSERT_EQ(sent.messages.size(), 3);
  // 2 m/s are 3.888 kn and 7.200 km/h, 0.123 m/s are 0.239 kn.
  EXPECT_TRUE(text(sent.messages[0]).starts_with("$VMVBW,3.888,0.239,A,,,V"))
      << text(sent.messages[0]);
  EXPECT_TRUE(text(sent.messages[1]).starts_with("$VMVHW,,T,,M,3.888,N,7.200,K*"))
      << text(sent.messages[1]);
  EXPECT_TRUE(text(sent.messages[2]).starts_with("$VMVLW,")) << text(sent.messages[2]);
}

TEST(EmulatedEmLog, ShowsAsMuchTooMuchAsTheRigSays) {
  const Frozen trajectory(under_way());
  auto config = device(DeviceKind::emlog, "nmea0183");
  config.speed_scale = 1.05;
  const auto sent = record(config, trajectory, 0);  // 2.1 m/s are 4.082 kn
  EXPECT_TRUE(text(sent.messages.at(0)).starts_with("$VMVBW,4.082,0.251,A,,,V"))
      << text(sent.messages[0]);
}

TEST(EmulatedEmLog, TheCurrentIsNotPartOfItsSpeed) {
  motion::Truth truth = under_way();
  truth.body_to_ned.setIdentity();
  truth.current_ned = {0.5, 0, 0};
  const Frozen trajectory(truth);
  const auto sent = record(device(DeviceKind::emlog, "nmea0183"), trajectory, 0);
  const auto vbw = std::get<wire::Vbw>(wire::Nmea0183::decode(sent.messages.at(0).bytes).value());
  EXPECT_NEAR(*vbw.water_longitudinal_mps, 1.5, 3e-4);
  EXPECT_FALSE(vbw.ground_longitudinal_mps);
}

TEST(EmulatedEmLog, CountsTheDistanceOnceASecond) {
  const Frozen trajectory(under_way());
  const auto sent = record(device(DeviceKind::emlog, "nmea0183", 5), trajectory, 1852 / 2);
  std::optional<double> total;
  int sentences = 0;
  for (const auto& message : sent.messages) {
    const auto decoded = wire::Nmea0183::decode(message.bytes).value();
    if (const auto* vlw = std::get_if<wire::Vlw>(&decoded)) {
      total = vlw->water_total_m;
      ++sentences;
    }
  }
  EXPECT_EQ(sentences, 927);
  EXPECT_NEAR(*total, 1852, 2);  // a nautical mile at 2 m/s
}

}  // namespace
}  // namespace drydock::emulate

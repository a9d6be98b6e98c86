#include <gtest/gtest.h>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/nmea2000/nmea2000.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {
namespace {

using rig_config::DeviceKind;
using wire::load_le;

// Frames of one PGN. Layouts and scales are from canboat's database.
std::vector<wire::CanFrame> of_pgn(const Recorder& sent, std::uint32_t pgn) {
  std::vector<wire::CanFrame> found;
  for (const auto& f : sent.frames) {
    if ((f.frame.id >> 8 & 0x3FFFF) == pgn) found.push_back(f.frame);
  }
  return found;
}

TEST(EmulatedDepth, SaysWaterPressureTemperatureAndTheBedBelow) {
  motion::Truth truth = under_way();
  truth.body_to_ned.setIdentity();
  const Frozen trajectory(truth);
  auto config = device(DeviceKind::depth, "nmea2000", 2);
  config.lever_arm_m = {0, 0, 1};
  const auto sent = record(config, trajectory, 1);
  EXPECT_EQ(sent.frames.at(0).frame.id, 0x18EEFF23);

  const auto pressure = of_pgn(sent, 130314).at(0);
  EXPECT_EQ(pressure.data[2], 1);  // water
  // Somigliana at 47.123456 deg: 9.808118 m/s2.
  const double column = 1025 * 9.808118 * 21;
  EXPECT_NEAR(load_le<std::int32_t>(pressure.payload(), 3) * 0.1, 101325 + column, 0.5);

  const auto temperature = of_pgn(sent, 130312).at(0);
  EXPECT_EQ(load_le<std::uint16_t>(temperature.payload(), 3), 28315);

  const auto below = of_pgn(sent, 128267).at(0);
  EXPECT_EQ(load_le<std::uint32_t>(below.payload(), 1), 2900);  // cm
  EXPECT_EQ(pressure.data[0], temperature.data[0]);
  EXPECT_EQ(pressure.data[0], below.data[0]);
}

TEST(EmulatedDepth, OutOfTheSoundersRangeTheBedIsNotAvailable) {
  motion::Truth truth = under_way();
  truth.bed_depth_m = 1000;
  const Frozen trajectory(truth);
  const auto sent = record(device(DeviceKind::depth, "nmea2000", 2), trajectory, 1);
  EXPECT_EQ(load_le<std::uint32_t>(of_pgn(sent, 128267).at(0).payload(), 1), 0xFFFFFFFF);
}

TEST(EmulatedActuators, ThreeSurfacesAndTheShaft) {
  const Frozen trajectory(under_way());
  const auto sent = record(device(DeviceKind::actuator, "nmea2000", 10), trajectory, 0.3);
  const auto surfaces = of_pgn(sent, 127245);
  // Position: i16 at byte 4, 0.0001 rad. On the wire a rudder to starboard is positive.
  const std::array<std::int16_t, 3> expected{-1100, -700, 500};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(surfaces.at(i).data[0], i);
    EXPECT_EQ(load_le<std::int16_t>(surfaces.at(i).payload(), 4), expected[i]);
  }
  // Shaft speed: u16 at byte 1, 0.25 rpm.
  const auto engine = of_pgn(sent, 127488).at(0);
  EXPECT_NEAR(load_le<std::uint16_t>(engine.payload(), 1) * 0.25, 150 / (2 * std::numbers::pi) * 60,
              0.125);
}

TEST(EmulatedNmea2000Device, AnswersARequestForItsAddressClaim) {
  const Frozen trajectory(under_way());
  const auto depth =
      make_emulated_device(device(DeviceKind::depth, "nmea2000"), trajectory, 1).value();
  Recorder sent;
  sent.run(*depth, at_s(0.5));
  const auto before = of_pgn(sent, 0x0EEFF).size();
  wire::CanFrame request;
  request.id = 0x18EAFFFE;  // from the null address to all
  request.extended = true;
  request.size = 3;
  request.data = {0x00, 0xEE, 0x00};
  depth->receive(request, sent.now, sent);
  EXPECT_EQ(of_pgn(sent, 0x0EEFF).size(), before + 1);
}

// PGN 65240 by the transport protocol: 9 bytes in two packets, with NAME and address.
TEST(EmulatedNmea2000Device, TakesTheAddressThatABroadcastCommandsIt) {
  const Frozen trajectory(under_way());
  const auto depth =
      make_emulated_device(device(DeviceKind::depth, "nmea2000"), trajectory, 1).value();
  Recorder sent;
  sent.run(*depth, at_s(0.5));
  const auto name = of_pgn(sent, 0x0EEFF).at(0).data;
  const auto hears = [&](std::uint32_t id, std::array<std::uint8_t, 8> data) {
    wire::CanFrame frame;
    frame.id = id;
    frame.extended = true;
    frame.size = 8;
    std::copy(data.begin(), data.end(), frame.data.begin());
    depth->receive(frame, sent.now, sent);
  };
  hears(0x1CECFF01, {0x20, 9, 0, 2, 0xFF, 0xD8, 0xFE, 0x00});
  hears(0x1CEBFF01, {1, name[0], name[1], name[2], name[3], name[4], name[5], name[6]});
  hears(0x1CEBFF01, {2, name[7], 0x9A, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF});
  EXPECT_EQ(sent.frames.back().frame.id, 0x18EEFF9A);
  sent.run(*depth, at_s(2.5));
  EXPECT_EQ(of_pgn(sent, 130314).back().id & 0xFF, 0x9AU);
}

}  // namespace
}  // namespace drydock::emulate

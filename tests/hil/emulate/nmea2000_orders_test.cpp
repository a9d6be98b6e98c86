#include "tests/hil/emulate/ordered_node.hpp"

namespace drydock::emulate {
namespace {

// Canboat's PGN database: 127245 has the instance, the direction order (3 bits) and the angle order
// in 1e-4 rad, positive to starboard. 06D1h is 1745: 10 degrees.
TEST(Nmea2000Orders, ARudderOrderOnNmea2000TurnsTheRudderToStarboard) {
  Node node(actuator("nmea2000", 0));
  node.hear("09F10D20#00F8D106FF7FFFFF");
  EXPECT_NEAR(node.at(1.5).rudder_rad, -2.5 * degree, 0.03 * degree);  // 2.5 deg/s
  node.hear("09F10D20#01F8D106FF7FFFFF");                              // stern planes
  node.hear("09F10D20#02F82FF9FF7FFFFF");                              // bow planes, F92Fh: -1745
  EXPECT_NEAR(node.at(2.5).stern_plane_rad, 2.5 * degree, 0.03 * degree);
  EXPECT_NEAR(node.at(2.5).bow_plane_rad, -2.5 * degree, 0.03 * degree);
}

TEST(Nmea2000Orders, ADirectionWithoutAnAngleIsTheWholeWay) {
  Node node(actuator("nmea2000", 0));
  for (int t = 1; t < 12; ++t) {
    node.hear("09F10D20#00FAFF7FFF7FFFFF");  // 2: to port
    node.run(t);
  }
  EXPECT_NEAR(node.at(11).rudder_rad, 20 * degree, 1e-6);
}

// 127488: instance, then the speed in quarters of a turn a minute; 0FA0h is 1000 turns a minute.
TEST(Nmea2000Orders, AnEngineSpeedOfAnotherNodeOrdersTheShaftOfItsInstance) {
  Node node(actuator("nmea2000", 1));
  node.hear("09F20020#01A00FFFFF7FFFFF");
  EXPECT_NEAR(node.at(2.2).propeller_radps, 1000 * 2 * std::numbers::pi / 60, 1e-5);
  node.hear("09F20020#00FFFFFFFF7FFFFF");
  node.hear("09F20020#00D007FFFF7FFFFF");  // instance 0
  EXPECT_NEAR(node.at(2.4).propeller_radps, 1000 * 2 * std::numbers::pi / 60, 1e-5);
}

TEST(Nmea2000Orders, AReportOfAnotherRudderIsNoOrder) {
  Node node(actuator("nmea2000", 0));
  node.hear("09F10D20#00F8FF7FD106FFFF");
  node.hear("09F10D20#05F8D106FF7FFFFF");
  EXPECT_EQ(node.at(2).rudder_rad, 0);
}

TEST(Nmea2000Orders, SilenceOfWhoeverSteersBringsTheRudderAmidshipsAndStopsTheShaft) {
  auto config = actuator("nmea2000", 0);
  config.stale_after_s = 2;
  Node node(config);
  node.hear("09F10D20#00F8D106FF7FFFFF");
  node.hear("09F20020#00A00FFFFF7FFFFF");
  node.run(2.45);
  EXPECT_LT(node.at(2.4).rudder_rad, -4 * degree);
  node.run(10);
  EXPECT_NEAR(node.at(9).rudder_rad, 0, 1e-6);
  EXPECT_NEAR(node.at(9).propeller_radps, 0, 1e-6);
}

}  // namespace
}  // namespace drydock::emulate

// Devices that get power, refuse settings or are hot, with their real drivers and the wire between
// them, in lockstep.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/hil/fault/line_bench.hpp"

namespace drydock::fault::test {
namespace power_up_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string dvl(const std::string& more) {
  return "[[device]]\nname = \"dvl\"\nkind = \"dvl\"\nprotocol = \"water-linked\"\n"
         "link = \"pty:dvl?baud=115200\"\nrate_hz = 5\n"
         "emulate.head.longest_range_m = 100\n" +
         more;
}

/// The driver sets the DVL to turn its velocities by 90 degrees. After a boot it turns them by 0.
const std::string turned = dvl("water_linked = { mounting_rotation_deg = 90 }\n");

std::string fault(const std::string& word, double start_s, double for_s) {
  return "[[fault]]\ndevice = \"dvl\"\nfault = \"" + word +
         "\"\nstart_s = " + std::to_string(start_s) + "\nfor_s = " + std::to_string(for_s) + "\n";
}

using measurement::BottomVelocity;

/// The mission goes straight ahead. A head that stands at 90 degrees and does not turn its
/// velocities would say that it goes to port.
void expect_ahead(const std::vector<BottomVelocity>& all) {
  for (const auto& m : all) {
    if (!m.velocity) continue;
    EXPECT_GT(m.velocity->x(), 1);
    EXPECT_LT(std::abs(m.velocity->y()), 0.5);
  }
}

std::size_t with_velocity(const std::vector<BottomVelocity>& all) {
  return static_cast<std::size_t>(
      std::ranges::count_if(all, [](const BottomVelocity& m) { return m.velocity.has_value(); }));
}

TEST(PowerUp, SettingsThatWereLostAreSetAgainAndNoVelocityIsOfTheOldAxes) {
  LineBench bench(turned, fault("off", 10, 5));
  bench.run_to(30);
  const auto before = bench.between<BottomVelocity>(2, 10),
             after = bench.between<BottomVelocity>(17, 30);
  EXPECT_EQ(with_velocity(before), before.size());
  EXPECT_THAT(bench.between<BottomVelocity>(11, 15), IsEmpty());
  EXPECT_EQ(with_velocity(after), after.size());
  EXPECT_GE(after.size(), 60u);
  expect_ahead(bench.between<BottomVelocity>(0, 30));
}

TEST(PowerUp, ADeviceThatBootsHearsNothingAndThenSaysItsBanner) {
  LineBench bench(
      dvl("emulate.boot_s = 4\nemulate.banner = \"Water Linked A50 ready\\r\\n\"\n"
          "water_linked = { mounting_rotation_deg = 0 }\n"));
  bench.run_to(3.9);
  EXPECT_THAT(bench.between<BottomVelocity>(0, 3.9), IsEmpty());
  EXPECT_EQ(bench.health().stream.bytes_in, 0u);
  bench.run_to(12);
  EXPECT_THAT(bench.between<BottomVelocity>(4, 12), Not(IsEmpty()));
  EXPECT_EQ(bench.health().stream.bytes_skipped, 24u) << "the banner, nothing else";
  EXPECT_EQ(bench.health().state, device::State::streaming);
}

TEST(PowerUp, ARefusalIsReportedAndVelocitiesOfOtherAxesAreNotGiven) {
  LineBench bench(turned, fault("nak", 0, 20));
  bench.run_to(15);
  EXPECT_EQ(with_velocity(bench.between<BottomVelocity>(0, 15)), 0u);
  EXPECT_THAT(std::string(bench.health().last_error.view()), HasSubstr("refuses"));
}

TEST(PowerUp, AHotDvlSaysSoShutsDownAndComesBack) {
  LineBench bench(
      dvl(""),
      "[[fault]]\ndevice = \"dvl\"\nfault = \"hot\"\nseconds = 3\nstart_s = 10\nfor_s = 8\n");
  bench.run_to(12);
  EXPECT_THAT(std::string(bench.health().last_error.view()), HasSubstr("hot"));
  EXPECT_EQ(with_velocity(bench.between<BottomVelocity>(10.5, 12)), 0u) << "out of the water";
  bench.run_to(30);
  EXPECT_THAT(bench.between<BottomVelocity>(13.5, 18), IsEmpty());
  EXPECT_GE(with_velocity(bench.between<BottomVelocity>(18, 30)), 55u);
  EXPECT_EQ(bench.health().state, device::State::streaming);
}

std::string gnss(const std::string& protocol) {
  return "[[device]]\nname = \"dvl\"\nkind = \"gnss\"\nprotocol = \"" + protocol +
         "\"\nlink = \"pty:gnss?baud=115200\"\nrate_hz = 1\nlever_arm_m = [0, 0, -1]\n"
         "emulate = { first_fix_s = 26 }\n";
}

TEST(PowerUp, AColdStartFindsSatellitesThenTheTimeThenItsFix) {
  for (const std::string protocol : {"ubx", "nmea0183"}) {
    LineBench bench(gnss(protocol), fault("off", 40, 2));
    bench.run_to(80);
    const auto fixes_between = [&](double from, double to) {
      const auto all = bench.between<measurement::GnssFix>(from, to);
      return std::ranges::count_if(all, [](const auto& m) { return m.position.has_value(); });
    };
    EXPECT_EQ(fixes_between(0, 26), 0) << protocol;
    EXPECT_GE(fixes_between(27, 40), 12) << protocol;
    EXPECT_EQ(fixes_between(43, 67), 0) << protocol << ": cold again after the cut";
    EXPECT_GE(fixes_between(70, 80), 9) << protocol;
    std::size_t most = 0;
    for (const auto& m : bench.between<measurement::GnssSatellites>(1, 26)) {
      EXPECT_GE(m.satellites.size(), most) << "one after the other";
      most = m.satellites.size();
    }
    EXPECT_GE(most, 5u) << protocol;
    for (const auto& m : bench.between<measurement::GnssFix>(1, 12))
      EXPECT_FALSE(m.utc) << protocol;
  }
}

}  // namespace power_up_test
}  // namespace drydock::fault::test

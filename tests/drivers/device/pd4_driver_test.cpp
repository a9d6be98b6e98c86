#include <cmath>

#include "tests/drivers/device/support.hpp"

/// The test builds reports from tables 48 and 49 of Teledyne's Pathfinder DVL Guide.
namespace drydock::device::test {
namespace pd4_driver_test {

using namespace std::chrono_literals;
using measurement::BottomVelocity;

constexpr std::uint8_t beam = 0x00, instrument = 0x40, ship = 0x80, earth = 0xC0, tilts = 0x20,
                       three_beam = 0x10;

struct Report {
  std::uint8_t configuration = instrument;
  std::array<int, 4> velocity_mmps{};
  std::array<int, 4> range_cm{1000, 1000, 1000, 1000};
  int pitch_cdeg = 0, roll_cdeg = 0, heading_cdeg = 0;
};

Octets pd(int which, const Report& report) {
  const std::size_t end = which == 4 ? 45 : 86;
  Octets out(end + 2, 0);
  out[0] = 0x7D;
  out[1] = which == 4 ? 0 : 1;
  put(out, 2, 2, static_cast<std::int64_t>(end));
  out[4] = report.configuration | 3;  // 600 kHz
  for (std::size_t i = 0; i < 4; ++i) {
    put(out, 5 + 2 * i, 2, report.velocity_mmps[i]);
    put(out, 13 + 2 * i, 2, report.range_cm[i]);
    put(out, 22 + 2 * i, 2, -32768);
  }
  const std::array<std::uint8_t, 4> clock{5, 6, 7, 50};
  std::copy(clock.begin(), clock.end(), out.begin() + 35);
  put(out, 41, 2, 1500);
  if (which == 5) {
    put(out, 48, 2, report.pitch_cdeg);
    put(out, 50, 2, report.roll_cdeg);
    put(out, 52, 2, report.heading_cdeg);
  }
  int sum = 0;
  for (std::size_t i = 0; i < end; ++i) sum += out[i];
  put(out, end, 2, sum % 65536);
  return out;
}

DriverOptions dvl(int which) { return options(Kind::dvl, which == 4 ? "pd4" : "pd5"); }

struct Heard {
  BottomVelocity measurement;
  std::vector<std::string> reports;
};

Heard heard(int which, const Report& report, const DriverOptions& o) {
  Ear ear;
  byte_driver(o)->receive(pd(which, report), at_s(1), ear);
  const auto all = ear.all<BottomVelocity>();
  EXPECT_EQ(all.size(), 1U);
  return {all.empty() ? BottomVelocity{} : all[0], ear.reports};
}
BottomVelocity heard(int which, const Report& report) {
  return heard(which, report, dvl(which)).measurement;
}

void expect_velocity(const BottomVelocity& m, double x, double y, double z, double within = 1e-12) {
  ASSERT_TRUE(m.velocity);
  EXPECT_NEAR(m.velocity->x(), x, within);
  EXPECT_NEAR(m.velocity->y(), y, within);
  EXPECT_NEAR(m.velocity->z(), z, within);
}

TEST(Pd4Driver, InstrumentAxesAreTheHeadsAndTheVehicleMoves) {
  // Starboard, bow, mast. Unlike PD0, no sign is reversed, except z, which points down here.
  for (const int which : {4, 5}) {
    const auto m = heard(which, {.velocity_mmps = {200, 1500, -100, 4}});
    expect_velocity(m, 1.5, 0.2, 0.1);
    EXPECT_EQ(m.error_velocity_mps, 0.004);
    EXPECT_EQ(m.sound_speed_mps, 1500);
    EXPECT_EQ(m.origin.device_time, 5h + 6min + 7s + 500ms);
  }
}

TEST(Pd4Driver, TheMountingTurnsTheHeadIntoTheBody) {
  DriverOptions o = dvl(4);
  o.mounting = {0, 0, 90 * degree};  // its bow points to starboard
  expect_velocity(heard(4, {.velocity_mmps = {200, 1500, -100, 4}}, o).measurement, -0.2, 1.5, 0.1);
}

TEST(Pd4Driver, BeamVelocitiesNeedTheBeamAngle) {
  // The vehicle moves at 2 m/s ahead, 0.5 to starboard, 0.1 down. The beams are 30 degrees from the
  // vertical, to port, starboard, bow and stern. A beam reads minus the velocity along its outward
  // direction.
  const double s = 0.5, c = std::sqrt(0.75);
  const auto mmps = [](double mps) { return static_cast<int>(std::lround(mps * 1000)); };
  Report report{.configuration = beam,
                .velocity_mmps = {mmps(0.5 * s - 0.1 * c), mmps(-0.5 * s - 0.1 * c),
                                  mmps(-2 * s - 0.1 * c), mmps(2 * s - 0.1 * c)}};
  DriverOptions o = dvl(4);
  const auto without = heard(4, report, o);
  EXPECT_FALSE(without.measurement.velocity);
  EXPECT_EQ(without.reports,
            (std::vector<std::string>{"no velocity: beam velocities, but no beam_angle_deg"}));

  o.dvl.beam_angle_rad = 30 * degree;
  expect_velocity(heard(4, report, o).measurement, 2, 0.5, 0.1, 2e-3);
  EXPECT_FALSE(heard(4, report, o).measurement.error_velocity_mps) << "the fourth is a beam";

  report.velocity_mmps[1] = -32768;
  EXPECT_FALSE(heard(4, report, o).measurement.velocity);
  report.configuration = beam | three_beam;
  expect_velocity(heard(4, report, o).measurement, 2, 0.5, 0.1, 3e-3);
}

TEST(Pd4Driver, LevelledVelocitiesNeedTheAttitudeThatOnlyPd5Tells) {
  // Bow 30 degrees up: 2 m/s along the bow are 1.732 ahead and 1 up in levelled axes.
  const Report levelled{
      .configuration = ship | tilts, .velocity_mmps = {0, 1732, 1000, 0}, .pitch_cdeg = 3000};
  expect_velocity(heard(5, levelled), 2, 0, 0, 1e-3);
  const auto without = heard(4, levelled, dvl(4));
  EXPECT_FALSE(without.measurement.velocity);
  ASSERT_EQ(without.reports.size(), 1U);
  EXPECT_NE(without.reports[0].find("levelled"), std::string::npos);

  // Heading east, level: 1 m/s east is ahead, 0.5 south is to starboard.
  const Report over_ground{
      .configuration = earth, .velocity_mmps = {1000, -500, 0, 0}, .heading_cdeg = 9000};
  expect_velocity(heard(5, over_ground), 1, 0.5, 0, 1e-12);
  EXPECT_FALSE(heard(4, over_ground).velocity);
}

TEST(Pd4Driver, WhatIsMissingIsReportedOnce) {
  Ear ear;
  const auto driver = byte_driver(dvl(4));
  const Octets report = pd(4, {.configuration = earth, .velocity_mmps = {1, 2, 3, 4}});
  driver->receive(report + report + report, at_s(1), ear);
  EXPECT_EQ(ear.all<BottomVelocity>().size(), 3U);
  EXPECT_EQ(ear.reports.size(), 1U);
}

TEST(Pd4Driver, AWaterLinkedHeadSendsForwardStarboardDownAndCallsItShip) {
  DriverOptions o = dvl(4);
  o.dvl.maker = DvlMaker::water_linked;
  const Report report{.configuration = ship | tilts, .velocity_mmps = {1234, -56, 78, 3}};
  const auto m = heard(4, report, o);
  expect_velocity(m.measurement, 1.234, -0.056, 0.078);
  EXPECT_TRUE(m.reports.empty());
}

TEST(Pd4Driver, NoBottomIsNoVelocityButALivingDvl) {
  const auto bad = heard(4, {.velocity_mmps = {-32768, -32768, -32768, -32768}, .range_cm = {}});
  EXPECT_FALSE(bad.velocity || bad.error_velocity_mps || bad.range_m[0] || bad.altitude_m);
  EXPECT_FALSE(heard(4, {.velocity_mmps = {}, .range_cm = {}}).velocity) << "zeros, no range";
}

TEST(Pd4Driver, OnlyPd5SaysEnoughForTheAltitude) {
  // 10 degrees of roll over a flat bed: beams 1 and 2 measure 20 m at 30 - 10 and 30 + 10 degrees.
  const auto component = [](double from_vertical_deg) {
    return static_cast<int>(
        std::lround(2000 / std::cos(from_vertical_deg * degree) * std::cos(30 * degree)));
  };
  const Report report{.range_cm = {component(20), component(40), 0, 0}, .roll_cdeg = 1000};
  EXPECT_NEAR(heard(5, report).altitude_m.value(), 20, 0.01);
  EXPECT_FALSE(heard(4, report).altitude_m);
  EXPECT_NEAR(heard(5, report).roll_rad.value(), 10 * degree, 1e-12);
}

TEST(Pd4Driver, NoReportIsLostAfterADamagedOne) {
  Octets damaged = pd(4, {});
  damaged[30] ^= 1;
  Ear ear;
  const auto driver = byte_driver(dvl(4));
  driver->receive(damaged + pd(4, {}), at_s(1), ear);
  EXPECT_EQ(ear.all<BottomVelocity>().size(), 1U);
  EXPECT_EQ(driver->counters().bad_checksums, 1U);
}

}  // namespace pd4_driver_test
}  // namespace drydock::device::test

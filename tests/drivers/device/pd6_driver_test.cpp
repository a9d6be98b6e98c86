#include "tests/drivers/device/support.hpp"

/// The lines are written by hand from table 50 of Teledyne's Pathfinder DVL Guide.
namespace drydock::device::test {
namespace pd6_driver_test {

using namespace std::chrono_literals;
using measurement::BottomVelocity;

using Ensemble = std::vector<std::string>;

/// 1.5 m/s ahead, 0.2 to starboard, 0.1 down; heading east, level.
Ensemble ensemble() {
  return {":SA, +0.00, +0.00, 90.00",
          ":TS,26030405060750,35.0,+12.3,   0.0,1500.0,  0",
          ":WI,   +10,   +20,   +30,    +0,A",
          ":WS,   +10,   +20,   +30,A",
          ":WE,   +10,   +20,   +30,A",
          ":WD,       +0.00,       +0.00,       +0.00,   5.00,  0.00",
          ":BI,  +200, +1500,  -100,    +4,A",
          ":BS,  +200, +1500,  -100,A",
          ":BE, +1500,  -200,  -100,A",
          ":BD,       +0.00,       +0.00,       +0.00,  12.80,  0.00"};
}

Octets bytes_of(const Ensemble& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\r\n";
  return octets(text);
}

std::vector<BottomVelocity> heard(const Octets& bytes,
                                  const DriverOptions& o = options(Kind::dvl, "pd6")) {
  Ear ear;
  byte_driver(o)->receive(bytes, at_s(1), ear);
  return ear.all<BottomVelocity>();
}

TEST(Pd6Driver, AWholeEnsembleIsOneMeasurement) {
  const auto all = heard(bytes_of(ensemble()));
  ASSERT_EQ(all.size(), 1U);
  const auto& m = all[0];
  EXPECT_NEAR(m.velocity->x(), 1.5, 1e-12);
  EXPECT_NEAR(m.velocity->y(), 0.2, 1e-12);
  EXPECT_NEAR(m.velocity->z(), 0.1, 1e-12);
  EXPECT_EQ(m.error_velocity_mps, 0.004);
  EXPECT_EQ(m.altitude_m, 12.8);
  EXPECT_NEAR(m.heading_rad.value(), 90 * degree, 1e-12);
  EXPECT_EQ(m.sound_speed_mps, 1500);
  using namespace std::chrono;
  EXPECT_EQ(m.origin.device_time,
            (sys_days{2026y / March / 4} + 5h + 6min + 7s + 500ms).time_since_epoch());
}

TEST(Pd6Driver, ItIsAsOldAsItsFirstLine) {
  DriverOptions o = options(Kind::dvl, "pd6");
  o.baud = 9600;
  o.latency = 40ms;
  const Octets bytes = bytes_of(ensemble());
  const auto m = heard(bytes, o).at(0);
  EXPECT_EQ(m.origin.received_at, at_s(1));
  const std::chrono::nanoseconds on_wire{bytes.size() * 10 * 1'000'000'000 / 9600};
  EXPECT_LT(std::chrono::abs(m.origin.valid_at - (at_s(1) - on_wire - 40ms)), 10ns);
}

TEST(Pd6Driver, NoHalfEnsembleIsPublished) {
  const Ensemble whole = ensemble();
  for (std::size_t lost : {1U, 6U, 7U, 8U, 9U}) {
    Ensemble lines = whole;
    lines.erase(lines.begin() + static_cast<long>(lost));
    // The next ensemble is complete.
    EXPECT_EQ(heard(bytes_of(lines) + bytes_of(whole)).size(), 1U) << whole[lost];
  }
  for (std::size_t cut = 1; cut < bytes_of(whole).size(); ++cut) {
    Octets head = bytes_of(whole);
    head.resize(cut);
    const auto all = heard(head + bytes_of(whole));
    EXPECT_EQ(all.size(), 1U) << "cut after " << cut;
  }
}

TEST(Pd6Driver, TheEndOfOneAndTheBeginOfAnotherAreNoEnsemble) {
  const Ensemble whole = ensemble();
  const Octets begin = bytes_of({whole.begin(), whole.begin() + 2});
  const Octets end = bytes_of({whole.begin() + 6, whole.end()});
  Ear ear;
  const auto driver = byte_driver(options(Kind::dvl, "pd6"));
  driver->receive(end + begin, at_s(1), ear);
  driver->receive(end, at_s(1.2), ear);  // all required lines, but 0.2 s later
  EXPECT_TRUE(ear.all<BottomVelocity>().empty());
  EXPECT_EQ(ear.reports.size(), 1U);
  driver->receive(begin, at_s(2), ear);
  driver->receive(end, at_s(2.05), ear);
  EXPECT_EQ(ear.all<BottomVelocity>().size(), 1U);
}

TEST(Pd6Driver, ADamagedLineSpoilsItsEnsembleAndNoOther) {
  Ensemble damaged = ensemble();
  damaged[7][6] = 'x';
  Ear ear;
  const auto driver = byte_driver(options(Kind::dvl, "pd6"));
  driver->receive(bytes_of(ensemble()) + bytes_of(damaged) + bytes_of(ensemble()), at_s(1), ear);
  EXPECT_EQ(ear.all<BottomVelocity>().size(), 2U);
  EXPECT_EQ(ear.reports.size(), 1U);
  EXPECT_EQ(driver->counters().bad_checksums, 1U);
}

TEST(Pd6Driver, LinesOfTheWaterLayerAndAttitudeMayBeMissing) {
  Ensemble lines = ensemble();
  lines.erase(lines.begin() + 2, lines.begin() + 6);
  lines.erase(lines.begin());
  const auto all = heard(bytes_of(lines) + bytes_of(lines));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_FALSE(all[1].heading_rad);
}

TEST(Pd6Driver, EarthVelocityIsTurnedBackWhereTheInstrumentsIsBad) {
  Ensemble lines = ensemble();
  lines[6] = ":BI,-32768,-32768,-32768,-32768,V";
  const auto m = heard(bytes_of(lines)).at(0);
  EXPECT_NEAR(m.velocity->x(), 1.5, 1e-12);
  EXPECT_NEAR(m.velocity->y(), 0.2, 1e-12);
  EXPECT_NEAR(m.velocity->z(), 0.1, 1e-12);
  EXPECT_FALSE(m.error_velocity_mps);
}

TEST(Pd6Driver, NoLockIsNoVelocityButALivingDvl) {
  Ensemble lines = ensemble();
  lines[6] = ":BI,-32768,-32768,-32768,-32768,V";
  lines[8] = ":BE,-32768,-32768,-32768,V";
  const auto m = heard(bytes_of(lines)).at(0);
  EXPECT_FALSE(m.velocity || m.altitude_m);
}

TEST(Pd6Driver, AWaterLinkedHeadSendsForwardStarboardDown) {
  DriverOptions o = options(Kind::dvl, "pd6");
  o.dvl.maker = DvlMaker::water_linked;
  const auto m = heard(bytes_of(ensemble()), o).at(0);
  EXPECT_NEAR(m.velocity->x(), 0.2, 1e-12);
  EXPECT_NEAR(m.velocity->y(), 1.5, 1e-12);
  EXPECT_NEAR(m.velocity->z(), -0.1, 1e-12);
}

TEST(Pd6Driver, SplitsDoNotMatter) {
  const Octets bytes = bytes_of(ensemble()) + bytes_of(ensemble());
  for (std::size_t size : {1U, 2U, 3U, 7U}) {
    Ear ear;
    const auto driver = byte_driver(options(Kind::dvl, "pd6"));
    for (std::size_t at = 0; at < bytes.size(); at += size) {
      driver->receive(wire::Bytes{bytes}.subspan(at, std::min(size, bytes.size() - at)), at_s(1),
                      ear);
    }
    EXPECT_EQ(ear.all<BottomVelocity>().size(), 2U) << size;
  }
}

}  // namespace pd6_driver_test
}  // namespace drydock::device::test

#include <fmt/format.h>

#include "tests/drivers/device/gnss_receiver.hpp"

/// The first message of an epoch is damaged. What the others tell is as old as the whole epoch. Ten
/// epochs come, one a second; a byte takes 10 bits.
namespace drydock::device::test {
namespace damaged_begin_test {

using namespace std::chrono_literals;
using measurement::BottomVelocity;
using measurement::GnssFix;
using measurement::GnssSatellites;

constexpr unsigned baud = 9600;
constexpr int epochs = 10, damaged = 5;

struct Line {
  Line(Kind kind, const std::string& protocol) {
    DriverOptions o = options(kind, protocol);
    o.baud = baud;
    driver = byte_driver(o);
  }
  /// Comes in one read that ends at `end`. Returns when its first byte began.
  Stamp says(const Octets& bytes, Stamp end) {
    driver->receive(bytes, end, ear);
    return end - std::chrono::nanoseconds{bytes.size() * 10'000'000'000 / baud};
  }

  Ear ear;
  std::unique_ptr<ByteDriver> driver;
};

/// `make(i)` is epoch i, in which `spoil(bytes)` damages one. `late`: so much after its second.
template <class Measurement, class Make, class Spoil>
std::vector<std::chrono::nanoseconds> late_by(Line line, Make&& make, Spoil&& spoil,
                                              std::chrono::nanoseconds late = 0ns) {
  std::vector<Stamp> begun;
  for (int i = 0; i < epochs; ++i) {
    Octets bytes = make(i);
    Stamp end = at_s(1 + i) + std::chrono::nanoseconds{bytes.size() * 10'000'000'000 / baud};
    if (i == damaged) spoil(bytes), end += late;
    begun.push_back(line.says(bytes, end));
  }
  line.driver->finish(line.ear);
  std::vector<std::chrono::nanoseconds> off;
  const auto told = line.ear.all<Measurement>();
  EXPECT_EQ(told.size(), begun.size());
  for (std::size_t i = 0; i < std::min(told.size(), begun.size()); ++i)
    off.push_back(told[i].origin.valid_at - begun[i]);
  return off;
}

const auto flip = [](Octets& bytes) { bytes.at(7) ^= 0x04; };

Octets ubx_epoch(int i) {
  const auto itow_ms = static_cast<std::uint32_t>(1000 * i);
  return nav_pvt({.itow_ms = itow_ms}) + nav_sat(itow_ms);
}

Octets nmea_epoch(int i) {
  const auto time = fmt::format("1027{:02}.000", i);
  return nmea("GPGGA," + time + ",4715.0,N,00830.0,E,1,11,0.9,400.0,M,48.0,M,,") +
         nmea("GPRMC," + time + ",A,4715.0,N,00830.0,E,1.9,90.0,040326,,,A");
}

Octets pd6_epoch(int i) {
  return octets(":SA, +0.00, +0.00, 90.00\r\n" +
                fmt::format(":TS,2603040506{:02}00,35.0,+12.3,   0.0,1500.0,  0\r\n", i) +
                ":BI,  +200, +1500,  -100,    +4,A\r\n:BS,  +200, +1500,  -100,A\r\n"
                ":BE, +1500,  -200,  -100,A\r\n"
                ":BD,       +0.00,       +0.00,       +0.00,  12.80,  0.00\r\n");
}

void expect_as_old_as_their_epoch(const std::vector<std::chrono::nanoseconds>& off) {
  for (std::size_t i = 0; i < off.size(); ++i) EXPECT_LT(std::chrono::abs(off[i]), 1us) << i;
}

TEST(DamagedBegin, SatellitesOfUbxBehindADamagedFixAreAsOldAsTheirEpoch) {
  expect_as_old_as_their_epoch(late_by<GnssSatellites>({Kind::gnss, "ubx"}, ubx_epoch, flip));
}

TEST(DamagedBegin, AFixOfTheNmeaSentencesThatAreLeftIsAsOldAsItsEpoch) {
  expect_as_old_as_their_epoch(late_by<GnssFix>({Kind::gnss, "nmea0183"}, nmea_epoch, flip));
}

TEST(DamagedBegin, AnEnsembleOfPd6WithoutItsAttitudeIsAsOldAsItsEpoch) {
  expect_as_old_as_their_epoch(late_by<BottomVelocity>({Kind::dvl, "pd6"}, pd6_epoch, flip));
}

/// The damage explains 104 ms at most, so 300 ms are true.
TEST(DamagedBegin, AnEpochThatIsLateItselfStaysLate) {
  const auto off = late_by<GnssSatellites>({Kind::gnss, "ubx"}, ubx_epoch, flip, 300ms);
  ASSERT_EQ(off.size(), std::size_t{epochs});
  EXPECT_NEAR(std::chrono::duration<double>(off[damaged]).count(), 100 * 10. / baud, 1e-6);
}

TEST(DamagedBegin, NoiseInFrontOfAnEpochMakesItNoOlder) {
  Line line(Kind::gnss, "ubx");
  std::vector<Stamp> begun;
  for (int i = 0; i < epochs; ++i) {
    const Octets bytes = ubx_epoch(i);
    const Stamp end = at_s(2 + i);
    begun.push_back(end - std::chrono::nanoseconds{bytes.size() * 10'000'000'000 / baud});
    line.says(i == damaged ? Octets(16, 0x55) + bytes : bytes, end);
  }
  const auto told = line.ear.all<GnssFix>();
  ASSERT_EQ(told.size(), begun.size());
  for (std::size_t i = 0; i < told.size(); ++i)
    EXPECT_LT(std::chrono::abs(told[i].origin.valid_at - begun[i]), 1us) << i;
}

}  // namespace damaged_begin_test
}  // namespace drydock::device::test

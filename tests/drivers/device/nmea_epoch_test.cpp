#include <fmt/format.h>

#include "tests/drivers/device/gnss_receiver.hpp"

/// Which sentences of a receiver are one fix, and of which day.
namespace drydock::device::test {
namespace nmea_epoch_test {

using measurement::FixType;
using measurement::GnssFix;
using namespace std::chrono;

Octets gga_of(int second, std::string_view height = "25.3") {
  return nmea(fmt::format("GPGGA,1005{:02},5307.0082,S,06724.6187,W,1,09,0.8,{},M,12.5,M,,", second,
                          height));
}
Octets rmc_of(int second) {
  return nmea(
      fmt::format("GPRMC,1005{:02},A,5307.0082,S,06724.6187,W,012.2,133.6,260319,010.7,E", second));
}

/// A logger stamps the lines of a receiver at 4800 baud: RMC, then GGA after `pause_s`. A sentence
/// of 72 characters takes 150 ms there.
Receiver stamped_line(double pause_s, std::optional<unsigned> baud = {}) {
  Receiver r("nmea0183", baud);
  for (int second = 0; second < 12; ++second) {
    r.says(rmc_of(second), second + 0.3);
    r.says(gga_of(second), second + 0.3 + pause_s);
  }
  r.driver->tick(at_s(20), r.ear);
  return r;
}

TEST(NmeaEpoch, SentencesOfOneTimeAreOneFixHoweverFarTheyStandApart) {
  for (const double pause_s : {0.08, 0.12, 0.2, 0.3, 0.45}) {
    const Receiver r = stamped_line(pause_s);
    ASSERT_EQ(r.fixes().size(), 12U) << pause_s;
    for (const GnssFix& fix : r.fixes()) {
      EXPECT_EQ(fix.type, FixType::three_d) << pause_s;
      EXPECT_TRUE(fix.ground_speed_mps && fix.mean_sea_level_height_m) << pause_s;
    }
    EXPECT_TRUE(r.ear.refusals.empty()) << pause_s;
  }
}

/// A log that begins in the middle of an epoch.
TEST(NmeaEpoch, TheEndOfAnEpochThatWasNotHeardIsNoPartOfTheFirstFix) {
  Receiver r("nmea0183");
  r.says(nmea("GPGSA,A,2,09,12,05,,,,,,,,,,9.4,0.8,1.2"), 0.5);
  r.says(rmc_of(1), 0.9);
  r.says(gga_of(1), 1.1);
  r.says(rmc_of(2), 1.9);
  ASSERT_EQ(r.fixes().size(), 1U);
  EXPECT_EQ(r.fixes()[0].origin.valid_at, at_s(0.9));
  EXPECT_EQ(r.fixes()[0].type, FixType::three_d);
}

/// A multiplexer may hold sentences back on a fast line too.
TEST(NmeaEpoch, APauseInsideIsLearnedOnALineWithABaudRateToo) {
  const Receiver r = stamped_line(0.2, 115200);
  ASSERT_EQ(r.fixes().size(), 12U);
  EXPECT_FALSE(r.fixes().front().mean_sea_level_height_m);
  EXPECT_EQ(r.ear.refusals.size(), 1U);
  for (std::size_t i = 1; i < 12; ++i) EXPECT_TRUE(r.fixes()[i].mean_sea_level_height_m);
}

TEST(NmeaEpoch, OfALineWithoutPausesInsideEndsSoonAfterItsLastSentence) {
  Receiver r("nmea0183");
  for (int second = 0; second < 6; ++second) r.says(rmc_of(second) + gga_of(second), second);
  EXPECT_EQ(r.driver->deadline(), at_s(5.1));
}

/// A receiver without a fix may repeat one time of day.
TEST(NmeaEpoch, ATimeThatStandsStillEndsItsEpochsAllTheSame) {
  Receiver r("nmea0183");
  for (int i = 0; i < 100; ++i) r.says(gga_of(0), 0.2 * i);
  EXPECT_GE(r.fixes().size(), 5U);
}

/// Magellan 315: GLL has milliseconds, GGA and RMC the same time cut to hundredths.
TEST(NmeaEpoch, OneTimeWithMoreAndFewerDecimalsIsOneEpoch) {
  Receiver r("nmea0183");
  r.says(nmea("GPGLL,3908.8199,N,00023.0832,W,120827.523,A") +
             nmea("GPGGA,120827.52,3908.8199,N,00023.0832,W,1,06,2.1,00176,M,,,,") +
             nmea("GPRMC,120827.52,A,3908.8199,N,00023.0832,W,00.0,000.0,130305,01.,W"),
         1);
  r.driver->tick(at_s(3), r.ear);
  ASSERT_EQ(r.fixes().size(), 1U);
  EXPECT_EQ(r.fixes()[0].origin.device_time, 12h + 8min + 27s + 523ms);
  EXPECT_EQ(r.fixes()[0].mean_sea_level_height_m, 176);
}

Octets gga_at(const std::string& time) {
  return nmea("GPGGA," + time + ",4916.4500,N,12311.1200,W,1,08,1.0,10.0,M,-16.0,M,,");
}

Stamp utc(sys_days day, nanoseconds since_midnight) {
  return Stamp{day.time_since_epoch() + since_midnight};
}

/// As gpsd gives the time of a later GLL by the date of an earlier RMC.
TEST(NmeaEpoch, TheDateThatWasToldIsCarriedOnOverMidnight) {
  Receiver r("nmea0183");
  r.says(gga_at("235958.00") + nmea("GPZDA,235958.00,06,04,2019,00,00"), 1);
  r.says(gga_at("235959.50"), 2.5);
  r.says(nmea("GPGLL,4916.4500,N,12311.1200,W,000001.00,A,A"), 4);
  r.says(nmea("GNGNS,100000.00,4916.45,N,12311.12,W,AA,08,1.0,10.0,-16.0,,"), 36003);
  r.says(gga_at("080000.00"), 36003 + 22 * 3600);
  r.driver->tick(at_s(200'000), r.ear);
  const sys_days sixth = 2019y / April / 6;
  std::vector<std::optional<Stamp>> told;
  for (const auto& fix : r.fixes()) told.push_back(fix.utc);
  EXPECT_EQ(told, (std::vector<std::optional<Stamp>>{utc(sixth, 24h - 2s), utc(sixth, 24h - 500ms),
                                                     utc(sixth, 24h + 1s), utc(sixth, 34h),
                                                     utc(sixth, 56h)}));
}

/// The clock of a receiver that has just been switched on may have any date.
TEST(NmeaEpoch, TheDateOfAReceiverWithoutAFixIsNotCarriedOn) {
  Receiver r("nmea0183");
  r.says(nmea("GPRMC,000001,V,,,,,,,060180,,"), 1);
  r.says(gga_at("235958.00"), 3);
  r.driver->tick(at_s(5), r.ear);
  ASSERT_EQ(r.fixes().size(), 2U);
  EXPECT_FALSE(r.fixes()[1].utc);
}

int satellites_of(const Octets& epoch) {
  Receiver r("nmea0183");
  r.says(epoch, 1);
  r.driver->tick(at_s(3), r.ear);
  return r.fixes().at(0).satellites_used.value_or(-1);
}

/// SiRFstarV and Quectel EG25, from gpsd's test logs: their GSA name 9 + 2 and 5 + 4 satellites.
TEST(NmeaEpoch, SatellitesUsedAreThoseOfAllConstellations) {
  const auto gga = [](const std::string& talker, const std::string& used) {
    return nmea(talker + "GGA,020937.000,4404.1351,N,12118.8557,W,1," + used +
                ",0.9,1123.8,M,-19.6,M,,0000");
  };
  EXPECT_EQ(satellites_of(gga("GP", "09") + gga("GL", "02")), 11);
  EXPECT_EQ(satellites_of(gga("GP", "09") + gga("GN", "11")), 11);
  EXPECT_EQ(satellites_of(gga("GN", "11") + gga("GP", "09") + gga("GL", "02")), 11);
  EXPECT_EQ(
      satellites_of(nmea("GPGGA,051347.00,6001.336799,N,03014.169008,E,1,05,0.9,16.5,M,18.0,M,,") +
                    nmea("GNGNS,051347.00,6001.336799,N,03014.169008,E,AAN,09,0.9,16.5,18.0,,,V")),
      9);
}

Octets rmc_by(const std::string& talker, int second, const std::string& speed) {
  return nmea(fmt::format("{}RMC,1200{:02}.00,A,4916.0000,N,12311.0000,W,{},090.0,180320,,,A",
                          talker, second, speed));
}

TEST(NmeaEpoch, OfTwoReceiversOnOneLineOneCountsAndTheOtherIsTold) {
  Receiver r("nmea0183");
  for (int second = 0; second < 4; ++second)
    r.says(
        rmc_by("GP", second, "1.0") +
            nmea(fmt::format(
                "IIGGA,1200{:02}.00,4916.0500,N,12311.0500,W,1,04,9.0,55.0,M,-16.0,M,,", second)) +
            nmea("IIVTG,180.0,T,,M,5.0,N,,K"),
        second);
  r.driver->tick(at_s(5), r.ear);
  ASSERT_EQ(r.fixes().size(), 4U);
  for (const GnssFix& fix : r.fixes()) {
    EXPECT_NEAR(fix.position->latitude_rad, (49 + 16.0 / 60) * degree, 1e-12);
    EXPECT_NEAR(fix.ground_speed_mps.value(), knot, 1e-12);
    EXPECT_FALSE(fix.mean_sea_level_height_m);
  }
  ASSERT_EQ(r.ear.refusals.size(), 8U);
  EXPECT_EQ(r.ear.refusals[0],
            "two receivers on one line: GP counts, sentences of II were left out");
}

TEST(NmeaEpoch, TheOtherReceiverCountsWhenTheFirstIsSilent) {
  Receiver r("nmea0183");
  for (int second = 0; second < 3; ++second) r.says(rmc_by("GP", second, "1.0"), second);
  for (int second = 3; second < 20; ++second) r.says(rmc_by("II", second, "2.0"), second);
  for (int second = 20; second < 23; ++second) r.says(rmc_by("GN", second, "3.0"), second);
  r.driver->tick(at_s(30), r.ear);
  std::string speeds;
  for (const GnssFix& fix : r.fixes())
    speeds += std::to_string(std::lround(fix.ground_speed_mps.value() / knot));
  EXPECT_EQ(speeds.substr(0, 4), "1112");
  EXPECT_EQ(speeds.substr(speeds.size() - 4), "2333");
}

/// Of one receiver, and of instruments beside it.
TEST(NmeaEpoch, TalkersOfConstellationsAndSentencesWithoutAPositionAreNoSecondReceiver) {
  Receiver r("nmea0183");
  for (int second = 0; second < 3; ++second)
    r.says(rmc_by("GN", second, "1.0") + rmc_by("GP", second, "1.0") +
               nmea("IIVTG,180.0,T,,M,1.0,N,,K") + nmea("GLGSV,1,1,01,65,50,010,30"),
           second);
  r.driver->tick(at_s(5), r.ear);
  EXPECT_EQ(r.fixes().size(), 3U);
  EXPECT_TRUE(r.ear.refusals.empty());
}

}  // namespace nmea_epoch_test
}  // namespace drydock::device::test

#include <gtest/gtest.h>

#include "drivers/wire/ubx/ubx.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// Frames 17 to 20 of fixtures/ubx/NOTE.md, and a capture of raw measurements.
namespace drydock::wire::testing {
namespace ubx_signals_test {

using namespace std::chrono_literals;

template <class M>
M golden() {
  static const auto reading = read_stream<Ubx>(fixture("ubx/golden.ubx"));
  return reading.all<M>().at(0);
}

TEST(UbxSignals, OneNumberStandsForConstellationAndSatelliteInNavSvinfo) {
  const auto satellites = golden<NavSvinfo>().satellites;
  ASSERT_EQ(satellites.size(), 6u) << "0 is no satellite";
  const std::vector<std::pair<UbxGnss, int>> expected{{UbxGnss::gps, 17},    {UbxGnss::sbas, 126},
                                                      {UbxGnss::glonass, 1}, {UbxGnss::beidou, 8},
                                                      {UbxGnss::beidou, 3},  {UbxGnss::galileo, 3}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(satellites[i].gnss, expected[i].first) << i;
    EXPECT_EQ(satellites[i].number, expected[i].second) << i;
  }
  const UbxSatellite& gps = satellites[0];
  EXPECT_EQ(gps.cno_dbhz, 43.0);
  EXPECT_NEAR(degrees(*gps.elevation_rad), 52, 1e-12);
  EXPECT_NEAR(degrees(*gps.azimuth_rad), 305, 1e-12);
  EXPECT_DOUBLE_EQ(gps.residual_m, -1.23);
  EXPECT_TRUE(gps.used && gps.has_ephemeris && !gps.healthy);
  EXPECT_EQ(gps.orbit_source, 1);
  EXPECT_EQ(satellites[1].orbit_source, 3) << "assistance";
  EXPECT_EQ(satellites[2].orbit_source, 2) << "almanac";
  EXPECT_FALSE(satellites[3].cno_dbhz || satellites[3].elevation_rad);
  EXPECT_EQ(satellites[3].healthy, false);
}

TEST(UbxSignals, NavSigTellsTheSignalsOfASatelliteApart) {
  const auto signals = golden<NavSig>().signals;
  ASSERT_EQ(signals.size(), 4u);
  EXPECT_EQ(signals[0].number, signals[1].number);
  EXPECT_EQ(signals[0].signal, 0);
  EXPECT_EQ(signals[1].signal, 3);
  EXPECT_EQ(signals[0].cno_dbhz, 44.0);
  EXPECT_DOUBLE_EQ(signals[0].residual_m, -1.2);
  EXPECT_TRUE(signals[0].pseudorange_used && signals[0].doppler_used && !signals[0].carrier_used);
  EXPECT_TRUE(signals[1].carrier_used);
  EXPECT_EQ(signals[0].correction_source, 1);
  EXPECT_EQ(signals[1].ionosphere_model, 8);
  EXPECT_EQ(signals[0].healthy, true);
  EXPECT_EQ(signals[2].healthy, false);
  EXPECT_EQ(signals[2].frequency_number, -4);
  EXPECT_FALSE(signals[0].frequency_number || signals[3].cno_dbhz || signals[3].healthy);
}

TEST(UbxSignals, RawMeasurementsAreThoseThatGpsdReads) {
  const auto m = golden<RxmRawx>();
  EXPECT_DOUBLE_EQ(m.receiver_time_s, 302400.199876);
  EXPECT_EQ(m.gps_week, 2446);
  EXPECT_EQ(m.leap_seconds, 18);
  EXPECT_FALSE(m.clock_reset);
  ASSERT_EQ(m.measurements.size(), 3u);
  const RawMeasurement& gps = m.measurements[0];
  EXPECT_NEAR(*gps.pseudorange_m, 21431659.961168, 1e-6);
  EXPECT_NEAR(*gps.carrier_phase_cycles, 112624126.092170, 1e-6);
  EXPECT_NEAR(*gps.doppler_hz, 366.010742, 1e-6);
  EXPECT_EQ(gps.lock_time, 64500ms);
  EXPECT_EQ(gps.cno_dbhz, 43.0);
  EXPECT_DOUBLE_EQ(*gps.pseudorange_sigma_m, 0.16);
  EXPECT_DOUBLE_EQ(*gps.carrier_sigma_cycles, 0.004);
  EXPECT_DOUBLE_EQ(*gps.doppler_sigma_hz, 0.128);
  EXPECT_TRUE(gps.half_cycle_resolved);
  EXPECT_EQ(m.measurements[1].frequency_number, 5);
  EXPECT_FALSE(m.measurements[1].carrier_sigma_cycles) << "15 is unknown";
}

TEST(UbxSignals, AMeasurementThatIsNotValidIsEmpty) {
  const RawMeasurement beidou = golden<RxmRawx>().measurements[2];
  EXPECT_FALSE(beidou.carrier_phase_cycles) << "the tracking status has no carrier";
  EXPECT_TRUE(beidou.pseudorange_m);
  Buffer payload(16 + 32, 0xFF);  // every double and float is NaN
  payload[11] = 1;
  RxmRawx m;
  EXPECT_FALSE(read(payload, m)) << "no time";
  for (std::size_t i = 0; i < 8; ++i) payload[i] = 0;
  ASSERT_TRUE(read(payload, m));
  EXPECT_FALSE(m.measurements[0].pseudorange_m || m.measurements[0].doppler_hz);
}

TEST(UbxSignals, NavigationWordsComeAsSent) {
  const auto m = golden<RxmSfrbx>();
  EXPECT_EQ(m.gnss, UbxGnss::gps);
  EXPECT_EQ(m.number, 3);
  EXPECT_EQ(m.channel, 6);
  ASSERT_EQ(m.words.size(), 10u);
  EXPECT_EQ(m.words[0], 0x22C13C0Du);
  EXPECT_EQ(m.words[9], 0x1007u);
}

TEST(UbxSignals, ACountThatContradictsTheLengthIsRefused) {
  NavSvinfo channels;
  NavSig signals;
  RxmRawx raw;
  RxmSfrbx words;
  const Buffer payload(16, 1);  // each count is 1
  EXPECT_FALSE(read(payload, channels) || read(payload, signals) || read(payload, raw) ||
               read(payload, words));
  EXPECT_FALSE(read(Buffer(3, 0), channels) || read(Buffer(3, 0), signals) ||
               read(Buffer(3, 0), raw) || read(Buffer(3, 0), words));
}

TEST(UbxSignals, TheLongestRawMessageFitsAndALongerClaimOfAnotherIsDamage) {
  const Buffer raw{0xB5, 0x62, 0x02, 0x15, 0xF0, 0x1F};  // 8176
  EXPECT_EQ(Ubx::scan(raw), Scan::need_more(8176 + 8));
  const Buffer longer{0xB5, 0x62, 0x02, 0x15, 0xF1, 0x1F};
  EXPECT_EQ(Ubx::scan(longer), Scan::skip(1));
  const Buffer other{0xB5, 0x62, 0x01, 0x07, 0xF0, 0x1F};
  EXPECT_EQ(Ubx::scan(other), Scan::skip(1));
}

/// gpsd 3.22 reads the same values, see the gpsd test.
TEST(UbxSignals, EveryRawMeasurementOfACaptureIsRead) {
  const auto log = corpora() / "gps/pyubx2/pygpsdata-RXMRAWX.log";
  if (!std::filesystem::exists(log)) GTEST_SKIP() << "no capture " << log;
  const auto epochs = read_stream<Ubx>(read_file(log)).all<RxmRawx>();
  ASSERT_EQ(epochs.size(), 14u);
  std::size_t measurements = 0;
  for (std::size_t i = 0; i < epochs.size(); ++i) {
    EXPECT_EQ(epochs[i].gps_week, 2327);
    EXPECT_NEAR(epochs[i].receiver_time_s, 223793.0 + static_cast<double>(i), 1e-6);
    measurements += epochs[i].measurements.size();
  }
  EXPECT_EQ(measurements, 314u) << "counted in the bytes by another program";
  EXPECT_NEAR(*epochs[0].measurements[1].pseudorange_m, 23388266.420824, 1e-6);
  EXPECT_NEAR(*epochs[0].measurements[6].carrier_phase_cycles, 109766763.532506, 1e-6);
}

}  // namespace ubx_signals_test
}  // namespace drydock::wire::testing

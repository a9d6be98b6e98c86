#include <bit>

#include "tests/drivers/device/support.hpp"

/// The records are put together by hand from the layout of the DVL manual; numbers of real ones
/// come from a DVL333.
namespace drydock::device::test {
namespace nortek_ad2cp_driver_test {

using namespace std::chrono_literals;
using measurement::BottomVelocity;

constexpr double none = -32.768;

/// What a record says. X, Y, Z1, Z2 and beams 1 to 4.
struct Told {
  std::array<double, 4> velocity{1.2, -0.3, 0.05, 0.05}, merit{0.003, 0.004, 0.002, 0.001};
  std::array<double, 4> distance{10, 10, 10, 10};
  double after_trigger = 0.025, after_output = -0.125;
  std::uint32_t error = 0;
};

std::uint16_t word_sum(const Octets& bytes, std::size_t begin, std::size_t end) {
  unsigned sum = 0xB58C;
  for (std::size_t i = begin; i < end; ++i) sum += bytes[i] << ((i - begin) % 2 == 1 ? 8 : 0);
  return static_cast<std::uint16_t>(sum);
}

void put_float(Octets& out, std::size_t offset, double value) {
  put(out, offset, 4, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

Octets closed(Octets record) {
  put(record, 6, 2, word_sum(record, 10, record.size()));
  put(record, 8, 2, word_sum(record, 0, 8));
  return record;
}

Octets record_1b(const Told& told, std::uint8_t id = 0x1B) {
  Octets r(222);
  r[0] = 0xA5, r[1] = 10, r[2] = id, r[3] = 0x10, r[4] = 212;
  r[10] = 1, r[11] = 36;
  const std::array<std::uint8_t, 6> clock{126, 10, 22, 14, 3, 59};
  std::ranges::copy(clock, r.begin() + 16);
  put(r, 22, 2, 5);  // 100 us
  put(r, 24, 2, 4);
  put(r, 26, 4, told.error);
  put_float(r, 34, 1501.5);
  std::uint32_t status = 0x10000000;
  for (std::size_t i = 0; i < 4; ++i) {
    put_float(r, 10 + 36 + 4 * i, 0.1);
    put_float(r, 10 + 52 + 4 * i, told.distance[i]);
    put_float(r, 10 + 132 + 4 * i, told.velocity[i]);
    put_float(r, 10 + 148 + 4 * i, told.merit[i]);
    put_float(r, 10 + 164 + 4 * i, told.velocity[i] == none ? 5.0125 : told.after_trigger);
    put_float(r, 10 + 180 + 4 * i, told.velocity[i] == none ? 4.37 : told.after_output);
    if (told.distance[i] != 0) status |= 0x10U << i;
    if (told.velocity[i] != none) status |= 0x1000U << i;
    if (told.merit[i] != 10) status |= 0x10000U << i;
  }
  put(r, 30, 4, status);
  return closed(r);
}

Ear hear(const Octets& bytes, const DriverOptions& o = options(Kind::dvl, "nortek-ad2cp")) {
  Ear ear;
  byte_driver(o)->receive(bytes, at_s(1), ear);
  return ear;
}

BottomVelocity heard(const Told& told,
                     const DriverOptions& o = options(Kind::dvl, "nortek-ad2cp")) {
  return hear(record_1b(told), o).all<BottomVelocity>().at(0);
}

TEST(NortekAd2cpDriver, VelocityInTheBodyRangesAndTheAltitudeOfALevelDvl) {
  DriverOptions o = options(Kind::dvl, "nortek-ad2cp");
  o.mounting = {0, 0, 90 * degree};  // its x axis points to starboard
  const auto m = heard({.distance = {8, 12, 16, 12}}, o);
  EXPECT_NEAR(m.velocity->x(), 0.3, 1e-6);
  EXPECT_NEAR(m.velocity->y(), 1.2, 1e-6);
  EXPECT_NEAR(m.velocity->z(), 0.05, 1e-6);
  EXPECT_EQ(m.range_m[2], 16.0);
  // Harmonic mean of 8, 16 and of 12, 12: 4 / (1/8 + 1/16 + 2/12).
  EXPECT_NEAR(*m.altitude_m, 4 / (1 / 8.0 + 1 / 16.0 + 2 / 12.0), 1e-9);
  EXPECT_EQ(m.sound_speed_mps, 1501.5);
  EXPECT_FALSE(m.heading_rad || m.pitch_rad);
}

TEST(NortekAd2cpDriver, TwoVerticalVelocitiesCountByTheirMerits) {
  const auto m = heard({.velocity = {1, 0, 0.1, 0.2}, .merit = {0.003, 0.004, 0.002, 0.001}});
  EXPECT_NEAR(m.velocity->z(), (0.1 / 4 + 0.2) / (1 / 4.0 + 1), 1e-6);
  EXPECT_NEAR(*m.error_velocity_mps, -0.1, 1e-6);
  const Eigen::Matrix3d& c = *m.velocity_covariance;
  EXPECT_NEAR(c(0, 0), 9e-6, 1e-11);
  EXPECT_NEAR(c(1, 1), 16e-6, 1e-11);
  EXPECT_NEAR(c(2, 2), 0.8e-6, 1e-11);  // 1 / (1/4 + 1) of 1e-6
  EXPECT_EQ(c(0, 1), 0);
}

TEST(NortekAd2cpDriver, TheCovarianceIsTurnedIntoTheBody) {
  DriverOptions o = options(Kind::dvl, "nortek-ad2cp");
  o.mounting = {0, 0, 90 * degree};
  const auto m = heard({.merit = {0.003, 0.004, 0.002, 0.001}}, o);
  EXPECT_NEAR((*m.velocity_covariance)(0, 0), 16e-6, 1e-11);
  EXPECT_NEAR((*m.velocity_covariance)(1, 1), 9e-6, 1e-11);
}

TEST(NortekAd2cpDriver, WithoutAMeritTheRigsSigmaCountsAndBothVerticalsCountAlike) {
  DriverOptions o = options(Kind::dvl, "nortek-ad2cp");
  o.velocity_sigma_mps = 0.5;
  const auto m = heard({.velocity = {1, 0, 0.1, 0.2}, .merit = {0.003, 0.004, 10, 0.001}}, o);
  EXPECT_NEAR(m.velocity->z(), 0.15, 1e-6);
  EXPECT_EQ(m.velocity_covariance, Eigen::Matrix3d(0.25 * Eigen::Matrix3d::Identity()));
}

TEST(NortekAd2cpDriver, ThreeBeamsAreAVelocityAndOnePairTheAltitude) {
  const auto ear = hear(record_1b({.velocity = {0.674, -0.013, -0.021, none},
                                   .merit = {0.0053, 0.0073, 0.0019, 10},
                                   .distance = {0, 6.5, 6.5, 6.75}}));
  const auto m = ear.all<BottomVelocity>().at(0);
  EXPECT_NEAR(m.velocity->z(), -0.021, 1e-6);
  EXPECT_NEAR((*m.velocity_covariance)(2, 2), 0.0019 * 0.0019, 1e-11);
  EXPECT_FALSE(m.error_velocity_mps || m.range_m[0]);
  EXPECT_NEAR(*m.altitude_m, 2 / (1 / 6.5 + 1 / 6.75), 1e-6);
  EXPECT_EQ(m.origin.valid_at, at_s(1) - 125ms) << "the rubbish of Z2 does not count";
  EXPECT_TRUE(ear.reports.empty());
}

TEST(NortekAd2cpDriver, AnIncompleteVelocityIsNoneAndIsSaidOnce) {
  const Octets part = record_1b({.velocity = {none, none, none, 0.05}, .merit = {10, 10, 10, 0.1}});
  const auto ear = hear(part + part + record_1b({}) + part);
  const auto all = ear.all<BottomVelocity>();
  ASSERT_EQ(all.size(), 4u);
  EXPECT_FALSE(all[0].velocity || all[0].velocity_covariance);
  EXPECT_TRUE(all[0].altitude_m && all[2].velocity);
  EXPECT_EQ(ear.reports.size(), 2u);
}

TEST(NortekAd2cpDriver, WithoutBottomThereIsAMeasurementWithoutVelocityAndNothingToSay) {
  const auto ear = hear(record_1b(
      {.velocity = {none, none, none, none}, .merit = {10, 10, 10, 10}, .distance = {0, 0, 0, 0}}));
  const auto m = ear.all<BottomVelocity>().at(0);
  EXPECT_FALSE(m.velocity || m.altitude_m || m.error_velocity_mps);
  EXPECT_TRUE(ear.reports.empty());
}

TEST(NortekAd2cpDriver, TheRecordSaysHowOldItIs) {
  DriverOptions o = options(Kind::dvl, "nortek-ad2cp");
  o.latency = 20ms;
  const auto valid_at = [&](double after_output) {
    return heard({.after_output = after_output}, o).origin.valid_at;
  };
  EXPECT_EQ(valid_at(-0.625), at_s(1) - 625ms);
  EXPECT_EQ(valid_at(0.5), at_s(1) - 20ms) << "an echo to come";
  EXPECT_EQ(valid_at(-9), at_s(1) - 20ms) << "an echo of long ago";
  EXPECT_EQ(valid_at(1e38), at_s(1) - 20ms);
}

TEST(NortekAd2cpDriver, TheDevicesTimeIsThatOfTheEcho) {
  const auto m = heard({.after_trigger = 0.03125});
  const auto clock = std::chrono::sys_days{std::chrono::year{2026} / 11 / 22}.time_since_epoch() +
                     14h + 3min + 59s + 500us;
  EXPECT_EQ(*m.origin.device_time, clock + 31250us);
}

TEST(NortekAd2cpDriver, WithoutBottomTheLatestTimesOfAnEchoHold) {
  const auto driver = byte_driver(options(Kind::dvl, "nortek-ad2cp"));
  Ear ear;
  driver->receive(record_1b({.after_trigger = 0.03125, .after_output = -0.125}), at_s(1), ear);
  driver->receive(record_1b({.velocity = {none, none, none, none}}), at_s(1), ear);
  const auto all = ear.all<BottomVelocity>();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_FALSE(all[1].velocity);
  EXPECT_EQ(all[1].origin.device_time, all[0].origin.device_time);
  EXPECT_EQ(all[1].origin.valid_at, at_s(1) - 125ms);
}

TEST(NortekAd2cpDriver, AnErrorOfTheDvlIsSaid) {
  const auto ear = hear(record_1b({.error = 8}));
  EXPECT_EQ(ear.reports.size(), 1u);
  EXPECT_TRUE(ear.all<BottomVelocity>().at(0).velocity);
}

TEST(NortekAd2cpDriver, WaterTrackIsNoVelocityOverTheBed) {
  EXPECT_TRUE(hear(record_1b({}, 0x1D)).all<BottomVelocity>().empty());
}

TEST(NortekAd2cpDriver, ASignatureGivesRangesAltitudeAndAttitudeButNoVelocityOfUnknownSign) {
  const Octets golden = read_all(std::filesystem::path(DRYDOCK_SOURCE_DIR) /
                                 "fixtures/nortek-ad2cp/golden.nortek-ad2cp");
  const auto ear = hear(golden);
  const auto all = ear.all<BottomVelocity>();
  ASSERT_EQ(all.size(), 7u);  // four records 1B and three 17
  const BottomVelocity& m = all[4];
  EXPECT_FALSE(m.velocity);
  EXPECT_EQ(m.range_m[0], 20.12);
  EXPECT_NEAR(*m.pitch_rad, 3.25 * degree, 1e-9);
  const double mean = 4 / (1 / 20.12 + 1 / 19.98 + 1 / 20.34 + 1 / 20.001);
  EXPECT_NEAR(*m.altitude_m, mean * std::cos(3.25 * degree) * std::cos(10.15 * degree), 2e-3);
  EXPECT_FALSE(all[5].altitude_m);
  EXPECT_NE(std::ranges::find_if(ear.reports,
                                 [](const auto& text) { return text.find("17") != text.npos; }),
            ear.reports.end());
}

/// The golden record 17 with its velocities in X, Y, Z1, Z2: bits 10 and 11 of the word at 30.
Octets signature_in_axes() {
  const auto frames = read_all(std::filesystem::path(DRYDOCK_SOURCE_DIR) /
                               "fixtures/nortek-ad2cp/golden.nortek-ad2cp");
  constexpr std::array<std::uint8_t, 4> head{0xA5, 10, 0x17, 0x10};
  const auto begin = std::search(frames.begin(), frames.end(), head.begin(), head.end());
  Octets record(begin, begin + 10 + 182);
  EXPECT_EQ(record[41] & 0x0C, 2 << 2) << "beams";
  record[41] = static_cast<std::uint8_t>((record[41] & ~0x0C) | 1 << 2);
  return closed(record);
}

TEST(NortekAd2cpDriver, ASignaturesVelocityIsThatOfTheVehicleOrOfTheBedAsTheRigSays) {
  for (const bool of_bed : {false, true}) {
    DriverOptions o = options(Kind::dvl, "nortek-ad2cp");
    o.dvl.velocity_of_bed = of_bed;
    o.mounting = {0, 0, 90 * degree};  // its x axis points to starboard
    const auto ear = hear(signature_in_axes(), o);
    const auto m = ear.all<BottomVelocity>().at(0);
    const double sign = of_bed ? -1 : 1;
    ASSERT_TRUE(m.velocity);
    EXPECT_NEAR(m.velocity->x(), sign * 0.567, 1e-9);
    EXPECT_NEAR(m.velocity->y(), sign * 1.234, 1e-9);
    EXPECT_NEAR(m.velocity->z(), sign * (-1.23 + 0.571) / 2, 1e-9);
    EXPECT_NEAR(*m.error_velocity_mps, sign * (-1.23 - 0.571), 1e-9);
    EXPECT_TRUE(ear.reports.empty());
  }
}

TEST(NortekAd2cpDriver, ASignatureWithoutTheRigsWordOrInAxesOfItsBeamsHasNoVelocity) {
  const auto unsigned_ear = hear(signature_in_axes());
  EXPECT_FALSE(unsigned_ear.all<BottomVelocity>().at(0).velocity);
  ASSERT_EQ(unsigned_ear.reports.size(), 1u);
  EXPECT_NE(unsigned_ear.reports[0].find("velocity_of"), std::string::npos);
  DriverOptions o = options(Kind::dvl, "nortek-ad2cp");
  o.dvl.velocity_of_bed = false;
  Octets beams = signature_in_axes();
  beams[41] = static_cast<std::uint8_t>((beams[41] & ~0x0C) | 2 << 2);
  const auto ear = hear(closed(beams), o);
  EXPECT_FALSE(ear.all<BottomVelocity>().at(0).velocity);
  ASSERT_EQ(ear.reports.size(), 1u);
  EXPECT_NE(ear.reports[0].find("X, Y, Z"), std::string::npos);
}

/// Speeds over the bed, each with the expected ones of another decoder.
TEST(NortekAd2cpDriver, ARealDvl333HasAVelocityInEveryRecordWithThreeBeams) {
  const auto file = corpora() / "dvl/ad2cp/raw/dvl333_dropouts.bin";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no captures";
  const auto ear = hear(read_all(file));
  const auto all = ear.all<BottomVelocity>();
  EXPECT_EQ(all.size(), 30u);
  EXPECT_EQ(std::ranges::count_if(all, [](const auto& m) { return m.velocity.has_value(); }), 29);
  EXPECT_EQ(std::ranges::count_if(all, [](const auto& m) { return !m.error_velocity_mps; }), 16);
  EXPECT_NEAR(all[8].velocity->x(), 0.67381215, 1e-7);
  EXPECT_NEAR(all[8].velocity->z(), -0.021329202, 1e-7);
}

}  // namespace nortek_ad2cp_driver_test
}  // namespace drydock::device::test

#include "tests/drivers/described/heard_of.hpp"

/// Inertial navigation units: one description for each kind of sensor that a telegram holds.
namespace drydock::described::test {
namespace navigation_units_test {

using measurement::AttitudeSample;
using measurement::BottomVelocity;
using measurement::DepthSample;
using measurement::GnssFix;

constexpr double degree = emulate::degree;

// The public sample: status 8A, hybrid; altitude and temperature bad.
TEST(DescribedHnav, TheSampleOfItsMakerReadsAsItsDecoderSays) {
  const auto attitude = heard_of_fixture("hnav-attitude.toml", "hnav.bin");
  ASSERT_EQ(attitude.all.size(), 3u);
  const auto& first = attitude.at<AttitudeSample>(0);
  EXPECT_NEAR(first.true_heading_rad.value() / degree, 72.88, 0.005);  // 72.97 with .0055 a count
  EXPECT_LT(std::abs(first.roll_rad.value()) / degree, 1);
  const auto position = heard_of_fixture("hnav-position.toml", "hnav.bin");
  const auto& fix = position.at<GnssFix>(0);
  EXPECT_NEAR(fix.position->latitude_rad / degree, 51.33064, 5e-6);
  EXPECT_NEAR(fix.position->longitude_rad / degree, -0.83569, 5e-6);
  // Bytes 11 to 18, microseconds of UTC since 1970: 2021-09-20 08:24:45.385372. Doubles of seconds
  // since 1970 have steps of 0.24 us.
  EXPECT_LT(std::abs(measurement::seconds(fix.utc.value() -
                                          measurement::stamp_from_ns(1'632'126'285'385'372'000))),
            0.24e-6);
  // CEP50 1.9952 m is 1.1774 sigma of each axis (Rayleigh).
  EXPECT_NEAR(*fix.horizontal_accuracy_m, 1.9952174 / 1.1774100 * std::numbers::sqrt2, 1e-5);
  const auto depth = heard_of_fixture("hnav-depth.toml", "hnav.bin");
  EXPECT_NEAR(depth.at<DepthSample>(0).depth_m.value(), -0.135, 1e-9);
}

TEST(DescribedHnav, ATelegramGivesWhatItsStatusDoesNotCallBad) {
  const auto attitude = heard_of_fixture("hnav-attitude.toml", "hnav.bin");
  const auto& second = attitude.at<AttitudeSample>(1);
  EXPECT_NEAR(second.roll_rad.value() / degree, -1.5, 0.003);
  EXPECT_NEAR(second.pitch_rad.value() / degree, 2.25, 0.003);
  EXPECT_NEAR(second.true_heading_rad.value() / degree, 359, 0.003);
  EXPECT_EQ(second.origin.device_time, std::chrono::seconds{1'700'000'000});
  EXPECT_FALSE(attitude.at<AttitudeSample>(2).heading_rad);
  const auto position = heard_of_fixture("hnav-position.toml", "hnav.bin");
  EXPECT_NEAR(position.at<GnssFix>(1).position->latitude_rad / degree, -33.5, 1e-7);
  EXPECT_NEAR(position.at<GnssFix>(1).position->longitude_rad / degree, 151.25, 1e-7);
  EXPECT_FALSE(position.at<GnssFix>(2).position || position.at<GnssFix>(2).utc);
  const auto velocity = heard_of_fixture("hnav-velocity.toml", "hnav.bin");
  EXPECT_LT((*velocity.at<BottomVelocity>(1).velocity - Eigen::Vector3d(2, 0.123, -0.045)).norm(),
            1e-12);
  EXPECT_FALSE(velocity.at<BottomVelocity>(2).velocity);
  const auto depth = heard_of_fixture("hnav-depth.toml", "hnav.bin");
  EXPECT_NEAR(depth.at<DepthSample>(1).depth_m.value(), 20.5, 1e-12);
  EXPECT_FALSE(depth.at<DepthSample>(2).depth_m);
}

TEST(DescribedStdbin, EveryVersionGivesItsAttitudeWithTheBowUp) {
  const auto heard = heard_of_fixture("stdbin-attitude.toml", "stdbin.bin");
  ASSERT_EQ(heard.all.size(), 4u) << "the last telegram has no attitude";
  const double expected[4][3] = {
      {123.5, -1.25, -2.5}, {359.75, 0.5, 0.25}, {10, 20, 30}, {45, 1, -1}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(heard.at<AttitudeSample>(i).true_heading_rad.value() / degree, expected[i][0],
                1e-5);
    EXPECT_NEAR(heard.at<AttitudeSample>(i).roll_rad.value() / degree, expected[i][1], 1e-5);
    EXPECT_NEAR(heard.at<AttitudeSample>(i).pitch_rad.value() / degree, expected[i][2], 1e-5);
  }
}

TEST(DescribedStdbin, APositionKeepsTheReferenceOfItsHeight) {
  const auto heard = heard_of_fixture("stdbin-position.toml", "stdbin.bin");
  ASSERT_EQ(heard.all.size(), 2u);
  const auto& ellipsoid = heard.at<GnssFix>(0);
  EXPECT_NEAR(ellipsoid.position->latitude_rad / degree, 43.25, 1e-12);
  EXPECT_NEAR(ellipsoid.position->longitude_rad / degree, -5.5, 1e-12) << "354.5 of 360";
  EXPECT_DOUBLE_EQ(ellipsoid.ellipsoidal_height_m.value(), 12.5);
  const auto& geoid = heard.at<GnssFix>(1);
  EXPECT_NEAR(geoid.position->longitude_rad / degree, 5.5, 1e-12);
  EXPECT_DOUBLE_EQ(geoid.mean_sea_level_height_m.value(), -2.5);
}

/// A telegram with these navigation blocks, by the maker's list of their sizes.
std::string stdbin_telegram(unsigned version, std::uint32_t blocks) {
  constexpr std::size_t sizes[] = {12, 12, 16, 8,  12, 12, 12, 21, 16, 12, 12, 8,  8,  4,  8, 16,
                                   12, 4,  4,  12, 4,  12, 12, 12, 8,  12, 16, 12, 12, 12, 12};
  std::string navigation;
  const auto put = [](std::string& to, std::uint64_t value, int bytes) {
    while (bytes-- > 0) to += static_cast<char>(value >> (8 * bytes));
  };
  for (unsigned bit = 0; bit < std::size(sizes); ++bit) {
    if ((blocks >> bit & 1) == 0) continue;
    if (bit != 7) {
      navigation.append(sizes[bit], '\x55');
      continue;
    }
    put(navigation, std::bit_cast<std::uint64_t>(43.25), 8);
    put(navigation, std::bit_cast<std::uint64_t>(5.5), 8);
    navigation += '\1';
    put(navigation, std::bit_cast<std::uint32_t>(12.5F), 4);
  }
  std::string whole = "IX";
  put(whole, version, 1);
  put(whole, blocks, 4);
  if (version >= 3) put(whole, 0, 4);
  put(whole, 0, 4);
  if (version >= 4) put(whole, navigation.size(), 2);
  put(whole, whole.size() + 2 + 8 + navigation.size() + 4, 2);
  put(whole, 12345, 4);
  put(whole, 7, 4);
  whole += navigation;
  std::uint32_t sum = 0;
  for (const char c : whole) sum += static_cast<unsigned char>(c);
  put(whole, sum, 4);
  return whole;
}

TEST(DescribedStdbin, APositionIsFoundBehindAnyBlocks) {
  for (const unsigned version : {2u, 3u, 4u, 5u})
    for (const std::uint32_t blocks : {0x80u, 0x81u, 0x181u, 0x1FFu, 0x2FFu, 0x7FFFFFFFu}) {
      const auto driver = driver_of(shipped("stdbin-position.toml"));
      Heard heard;
      receive(*driver, stdbin_telegram(version, blocks), Stamp{}, heard);
      ASSERT_EQ(heard.all.size(), 1u) << version << " " << std::hex << blocks;
      const auto& fix = heard.at<GnssFix>(0);
      EXPECT_NEAR(fix.position->latitude_rad / degree, 43.25, 1e-12);
      EXPECT_NEAR(fix.position->longitude_rad / degree, 5.5, 1e-12);
      EXPECT_EQ(fix.ellipsoidal_height_m, 12.5);
      EXPECT_EQ(driver->counters().bytes_skipped, 0u);
    }
}

TEST(DescribedStdbin, ATelegramWithoutAPositionIsNoDamagedOne) {
  const auto driver = driver_of(shipped("stdbin-position.toml"));
  Heard heard;
  receive(*driver, stdbin_telegram(3, 0x101), Stamp{}, heard);
  EXPECT_TRUE(heard.all.empty());
  EXPECT_EQ(driver->counters().frames, 1u);
  EXPECT_EQ(driver->counters().bytes_skipped, 0u);
}

}  // namespace navigation_units_test
}  // namespace drydock::described::test

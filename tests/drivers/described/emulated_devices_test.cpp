#include <gmock/gmock.h>

#include "tests/drivers/described/driven.hpp"

/// Emulated devices of the shipped descriptions: what their drivers read is the truth. Under way:
/// 20 m deep, 30 m above the bed, 2 m/s ahead, 0.123 to starboard, -0.045 down; roll 3, pitch -4,
/// heading 290 degrees.
namespace drydock::described::test {
namespace emulated_devices_test {

using measurement::AttitudeSample;
using measurement::BottomVelocity;
using measurement::DepthSample;
using measurement::GnssFix;

constexpr double degree = emulate::degree;

TEST(DescribedDevices, AnEmulatedValeportGivesTheTruthBack) {
  Bench bench("valeport-vat.toml");
  bench.run(10);
  ASSERT_NEAR(static_cast<double>(bench.all.size()), 41, 1);
  const auto& sample = std::get<DepthSample>(bench.all.back());
  EXPECT_NEAR(*sample.altitude_m, 30, 0.0005);
  EXPECT_NEAR(*sample.depth_m, 20, 0.2) << "standard gravity, as at sea";
}

TEST(DescribedDevices, AnEmulatedSounderOfAnyTalkerGivesTheTruthBack) {
  Bench bench("nmea-depth.toml");
  bench.run(10);
  ASSERT_GE(bench.all.size(), 41u);
  const auto heard = [&](auto member) {
    return std::ranges::any_of(bench.all, [&](const auto& m) {
      const auto& value = std::get<DepthSample>(m).*member;
      return value && std::abs(*value - 30) < 0.06;  // DBT has a tenth of a metre
    });
  };
  EXPECT_TRUE(heard(&DepthSample::altitude_m));
  const auto heights = std::ranges::count_if(
      bench.all, [](const auto& m) { return std::get<DepthSample>(m).altitude_m.has_value(); });
  EXPECT_NEAR(static_cast<double>(heights), 41, 1) << "one of a ping, though DPT says it again";
}

// 30 m above the bed. NMEA 0183: DBT in feet, metres and fathoms, DPT in metres with the offset of
// the transducer and the range scale.
TEST(DescribedDevices, AnEmulatedSounderSaysTheDepthAsDbtAndAsDpt) {
  const auto sounder = shipped("nmea-depth.toml");
  wire::described::Readings readings;
  readings.set(wire::described::Target::altitude, 30);
  std::string said;
  for (const auto& message : sounder->plan.messages) {
    if (!message.emulated) continue;
    std::array<std::uint8_t, 256> line;
    const auto size = wire::described::encode(sounder->plan, message, readings, line);
    said.append(reinterpret_cast<const char*>(line.data()), size);
  }
  EXPECT_THAT(said, testing::HasSubstr("DBT,98.4,f,30.0,M,16.4,F*"));
  EXPECT_THAT(said, testing::HasSubstr("DPT,30.0,0.0,200*"));
}

TEST(DescribedDevices, AnEmulatedKellerAnswersWhatItsDriverAsks) {
  Bench bench("keller.toml");
  bench.run(10);
  ASSERT_NEAR(static_cast<double>(bench.all.size()), 40, 2);
  EXPECT_NEAR(*std::get<DepthSample>(bench.all.back()).depth_m, 20, 0.2);
}

TEST(DescribedDevices, AnEmulatedDigiquartzSendsOnceItWasStarted) {
  Bench bench("digiquartz.toml");
  bench.run(10);
  EXPECT_GE(bench.all.size(), 36u);
  EXPECT_NEAR(*std::get<DepthSample>(bench.all.back()).depth_m, 20, 0.2);
}

TEST(DescribedDevices, EmulatedDvlsGiveTheVelocityOfTheTruthBack) {
  for (const char* file : {"cerulean-dvpdl.toml", "nortek-bt.toml", "water-linked-wrz.toml"}) {
    Bench bench(file, 5);
    bench.run(5);
    ASSERT_GE(bench.all.size(), 24u) << file;
    const auto& sample = std::get<BottomVelocity>(bench.all.back());
    ASSERT_TRUE(sample.velocity) << file;
    EXPECT_NEAR(sample.velocity->x(), 2, 0.001) << file;
    EXPECT_NEAR(sample.velocity->y(), 0.123, 0.001) << file;
    EXPECT_NEAR(sample.velocity->z(), -0.045, 0.001) << file;
  }
}

TEST(DescribedDevices, EmulatedCompassesGiveTheAttitudeOfTheTruthBack) {
  for (const char* file : {"hnav-attitude.toml", "stdbin-attitude.toml"}) {
    Bench bench(file, 10);
    bench.run(5);
    ASSERT_GE(bench.all.size(), 48u) << file;
    const auto& last = std::get<AttitudeSample>(bench.all.back());
    EXPECT_NEAR(last.true_heading_rad.value() / degree, 290, 0.003) << file;
    EXPECT_NEAR(last.roll_rad.value() / degree, 3, 0.003) << file;
    EXPECT_NEAR(last.pitch_rad.value() / degree, -4, 0.003) << file;
  }
  Bench sentences("nmea-heading.toml", 10);
  sentences.run(5);
  ASSERT_GE(sentences.all.size(), 48u);
  EXPECT_NEAR(std::get<AttitudeSample>(sentences.all.back()).true_heading_rad.value() / degree, 290,
              0.005);
}

TEST(DescribedDevices, EmulatedNavigationUnitsGivePositionVelocityAndDepthBack) {
  for (const char* file : {"hnav-position.toml", "stdbin-position.toml"}) {
    Bench bench(file, 10, emulate::at_the_surface());
    bench.run(5);
    ASSERT_GE(bench.all.size(), 48u) << file;
    const auto& fix = std::get<GnssFix>(bench.all.back());
    const auto truth = bench.truth().at(fix.origin.valid_at);
    EXPECT_NEAR(fix.position->latitude_rad, truth.latitude_rad, 2e-9) << file;
    EXPECT_NEAR(fix.position->longitude_rad, truth.longitude_rad, 2e-9) << file;
  }
  Bench under_water("hnav-position.toml", 10);
  under_water.run(5);
  ASSERT_GE(under_water.all.size(), 48u) << "the telegram comes, and its status says bad";
  EXPECT_FALSE(std::get<GnssFix>(under_water.all.back()).position);
  Bench velocity("hnav-velocity.toml", 10);
  velocity.run(5);
  EXPECT_NEAR(std::get<BottomVelocity>(velocity.all.back()).velocity->y(), 0.123, 0.001);
  Bench depth("hnav-depth.toml", 10);
  depth.run(5);
  EXPECT_NEAR(*std::get<DepthSample>(depth.all.back()).depth_m, 20, 0.2);
}

}  // namespace emulated_devices_test
}  // namespace drydock::described::test

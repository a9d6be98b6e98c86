#include "tests/drivers/described/driven.hpp"
#include "tests/drivers/device/allocation_count.hpp"

/// What a described driver makes of what its sensor says.
namespace drydock::described::test {
namespace described_driver_test {

TEST(DescribedDrivers, TheLineTimeAndTheStatedAgeGiveTheTimeOfValidity) {
  auto options = options_of(shipped("nortek-bt.toml"));
  options.baud = 9600;
  Heard heard;
  const auto driver = *device::make_byte_driver(options);
  const std::string line =
      "$PNORBT7,1452244916.7508,1.234,-1.234,0.1234,0.1234,0.1234,12.34,23.45,23.45,23.45,23.45*"
      "39\r\n";
  const Stamp end = measurement::stamp_from_ns(1'000'000'000);
  receive(*driver, line, end, heard);
  ASSERT_EQ(heard.all.size(), 1u);
  const auto& sample = heard.last<measurement::BottomVelocity>();
  // 10 bits a byte at 9600 baud, then the age of 1.234 ms.
  const double line_s = static_cast<double>(line.size()) * 10 / 9600;
  EXPECT_NEAR(measurement::seconds(end - sample.origin.valid_at), line_s + 1.234e-3, 1e-6);
  EXPECT_NEAR(measurement::seconds(*sample.origin.device_time), 1452244916.7508, 1e-6);
  EXPECT_DOUBLE_EQ(sample.velocity->x(), 0.1234);
}

TEST(DescribedDrivers, ADescribedDvlIsPutRightForTheSpeedOfSoundToo) {
  auto options = options_of(shipped("nortek-bt.toml"));
  using Source = device::SoundSpeedOptions::Source;
  options.dvl.sound_speed.source = Source::fixed;
  options.dvl.sound_speed.fixed_mps = 1470;
  options.dvl.sound_speed.set_mps = 1500;
  Heard heard;
  const auto driver = *device::make_byte_driver(options);
  receive(
      *driver,
      "$PNORBT7,1452244916.7508,1.234,-1.234,0.1234,0.1234,0.1234,12.34,23.45,23.45,23.45,23.45*"
      "39\r\n",
      {}, heard);
  ASSERT_EQ(heard.all.size(), 1u);
  EXPECT_NEAR(heard.last<measurement::BottomVelocity>().velocity->x(), 0.98 * 0.1234, 1e-12);
  EXPECT_NEAR(heard.last<measurement::BottomVelocity>().range_m[0].value(), 0.98 * 23.45, 1e-12);
}

// 7.7 ft are 2.3 m: the sounder says one depth in two sentences.
TEST(DescribedDrivers, ASentenceThatSaysTheSameCountsOnlyWhileTheOtherDoesNotCome) {
  const std::string dbt = "$SDDBT,7.7,f,2.3,M,1.3,F*05\r\n", dpt = "$INDPT,2.2,0.0*47\r\n";
  const auto at_s = [](int s) { return measurement::stamp_from_ns(s * 1'000'000'000LL); };
  Heard heard;
  const auto driver = driver_of(shipped("nmea-depth.toml"));
  receive(*driver, dpt, at_s(1), heard);
  EXPECT_EQ(heard.last<measurement::DepthSample>().altitude_m, 2.2);
  receive(*driver, dbt + dpt, at_s(2), heard);
  receive(*driver, dpt, at_s(4), heard);
  EXPECT_EQ(heard.all.size(), 2u);
  EXPECT_EQ(heard.last<measurement::DepthSample>().altitude_m, 2.3);
  receive(*driver, dpt, at_s(5), heard);
  EXPECT_EQ(heard.all.size(), 3u) << "DBT is 3 s old";
}

TEST(DescribedDrivers, AMisfitAndAFieldThatIsNoNumberAreTold) {
  Heard heard;
  const auto driver = driver_of(shipped("valeport-vat.toml"));
  receive(*driver, "$PRVAT,1,M*3D\r\n", {}, heard);  // too few fields; XOR by hand
  EXPECT_TRUE(heard.all.empty());
  ASSERT_EQ(heard.refusals.size(), 1u);
  receive(*driver, "$PRVAT,x,M,0010.073,dBar*5A\r\n", {}, heard);
  EXPECT_EQ(heard.reports.size(), 1u);
  ASSERT_EQ(heard.all.size(), 1u) << "the other field counts";
  EXPECT_FALSE(heard.last<measurement::DepthSample>().altitude_m);
}

constexpr std::string_view depth_alone = R"(
[sensor]
title = "A sensor of depth"
kind = "depth"
[protocol]
checksum = "none"
[[protocol.sentences]]
id = "$PD"
fields = [{field = "depth_m", unit = "m"}]
)";

TEST(DescribedDrivers, ADepthThatNoSeaHasIsRefusedAsAPressureIs) {
  Heard heard;
  const auto driver = driver_of(described(depth_alone));
  for (const char* depth : {"1e30", "-1e30", "12000.1", "-100.1", "-2147483648"})
    receive(*driver, "$PD," + std::string(depth) + "\r\n", {}, heard);
  EXPECT_TRUE(heard.all.empty());
  EXPECT_EQ(heard.refusals.size(), 5u);
  for (const char* depth : {"10902", "-2.5", "0"})  // Challenger Deep; on deck; at the surface
    receive(*driver, "$PD," + std::string(depth) + "\r\n", {}, heard);
  EXPECT_EQ(heard.all.size(), 3u);
}

TEST(DescribedDrivers, AHeightOverTheBedBelowZeroIsRefused) {
  Heard heard;
  const auto driver = driver_of(shipped("nmea-depth.toml"));
  receive(*driver, "$INDPT,-500.0,0.0*6F\r\n", {}, heard);
  EXPECT_TRUE(heard.all.empty());
  EXPECT_EQ(heard.refusals.size(), 1u);
}

TEST(DescribedDrivers, NoMessageAllocates) {
  for (const auto& [file, golden] :
       {std::pair("valeport-vat.toml", "valeport-vat.txt"),
        std::pair("water-linked-wrz.toml", "water-linked-wrz.txt"),
        std::pair("keller.toml", "keller.bin"), std::pair("digiquartz.toml", "digiquartz.txt")}) {
    struct Nowhere final : device::Output {
      void publish(const measurement::Measurement&) override { ++count; }
      void send(wire::Bytes) override {}
      void send(const wire::CanFrame&) override {}
      int count = 0;
    } nowhere;
    const auto driver = driver_of(shipped(file));
    const auto stream = wire::testing::fixture(std::string("described/") + golden);
    const device::test::AllocationCount allocations;
    for (int i = 0; i < 100; ++i)
      driver->receive(stream, measurement::stamp_from_ns(i * 1'000'000'000LL), nowhere);
    EXPECT_EQ(allocations.so_far(), 0u) << file;
    EXPECT_GE(nowhere.count, 100);
  }
}

}  // namespace described_driver_test
}  // namespace drydock::described::test

#include <gmock/gmock.h>

#include "tests/drivers/described/heard_of.hpp"
#include "tests/drivers/device/allocation_count.hpp"

/// Packets that are made of records, each with its identifier and length: MIP and MTData2.
namespace drydock::described::test {
namespace records_test {

using measurement::AttitudeSample;
using measurement::ImuSample;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using wire::testing::Buffer;

constexpr double degree = emulate::degree;

constexpr double g = 9.80665;

Buffer packet(const std::string& golden, std::size_t from, std::size_t size) {
  const Buffer all = wire::testing::fixture("described/" + golden);
  return {all.begin() + static_cast<long>(from), all.begin() + static_cast<long>(from + size)};
}

TEST(Records, OfMipAreForcesRatesAndTheTime) {
  const auto heard = heard_of_fixture("mip-imu.toml", "mip.bin");
  ASSERT_EQ(heard.all.size(), 2u);
  const auto& imu = heard.at<ImuSample>(0);
  const Eigen::Vector3d force(0.19661863, -0.00250356, -0.97900563);  // read with another program
  const Eigen::Vector3d rate(-0.00607933, -0.00248420, 0.00218142);
  EXPECT_LT((imu.specific_force - g * force).norm(), 1e-7);
  EXPECT_LT((imu.angular_rate - rate).norm(), 1e-8);
  EXPECT_EQ(imu.origin.device_time, std::chrono::milliseconds{112'417});
  const auto& other_order = heard.at<ImuSample>(1);
  EXPECT_EQ(other_order.specific_force, imu.specific_force);
  EXPECT_EQ(other_order.angular_rate, imu.angular_rate);
  EXPECT_FALSE(other_order.origin.device_time);
}

TEST(Records, OfMipAreTheAnglesOfTheFilterIfItSaysThatTheyHold) {
  const auto heard = heard_of_fixture("mip-attitude.toml", "mip-filter.bin");
  ASSERT_EQ(heard.all.size(), 2u);
  const auto& attitude = heard.at<AttitudeSample>(0);
  EXPECT_NEAR(attitude.roll_rad.value(), 0.1, 1e-7);
  EXPECT_NEAR(attitude.pitch_rad.value(), -0.2, 1e-7);
  EXPECT_NEAR(attitude.true_heading_rad.value(), 2 * std::numbers::pi - 1.5, 1e-6);
  EXPECT_FALSE(heard.at<AttitudeSample>(1).roll_rad);
}

/// MT Manager's figures, y and z turned to starboard and down. The unit lay level: its force is up.
TEST(Records, OfMtdata2AreForcesAndRatesInTheAxesOfAVehicle) {
  const auto heard = heard_of_fixture("xsens-mtdata2.toml", "mtdata2.bin");
  ASSERT_EQ(heard.all.size(), 1u) << "the other two measure no forces, and are no damaged ones";
  EXPECT_TRUE(heard.refusals.empty());
  EXPECT_TRUE(heard.reports.empty());
  const auto& imu = heard.at<ImuSample>(0);
  const Eigen::Vector3d force(-0.07915300, 0.16655955, -9.82217598);
  const Eigen::Vector3d rate(-0.00541657, 0.00458360, -0.00792891);
  EXPECT_LT((imu.specific_force - force).norm(), 1e-8);
  EXPECT_LT((imu.angular_rate - rate).norm(), 1e-8);
  EXPECT_EQ(imu.origin.device_time, std::chrono::microseconds{571'985'400});
}

/// The angles of the quaternions' matrices, computed apart. The first unit lay level and looked
/// nearly east; the nose of the third pointed nearly up.
TEST(Records, OfMtdata2AreAnAttitude) {
  const auto heard = heard_of_fixture("xsens-mtdata2-attitude.toml", "mtdata2.bin");
  ASSERT_EQ(heard.all.size(), 3u);
  const double expected[3][3] = {{-1.04079, -0.50043, 97.13721},
                                 {-37.73065, 0.61913, 96.68462},
                                 {-156.89839, 88.80799, 202.94229}};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& attitude = heard.at<AttitudeSample>(i);
    EXPECT_NEAR(attitude.roll_rad.value() / degree, expected[i][0], 1e-4);
    EXPECT_NEAR(attitude.pitch_rad.value() / degree, expected[i][1], 1e-4);
    EXPECT_NEAR(attitude.true_heading_rad.value() / degree, expected[i][2], 1e-4);
  }
  EXPECT_EQ(heard.at<AttitudeSample>(2).origin.device_time, std::chrono::microseconds{71'892'400});
}

TEST(Records, ThatNobodyDescribedAreNamed) {
  const wire::described::DescribedCodec codec(shipped("xsens-mtdata2.toml"));
  std::vector<std::uint16_t> unread;
  codec.unread_blocks(packet("mtdata2.bin", 0, 144),
                      [&](std::uint16_t id) { unread.push_back(id); });
  EXPECT_THAT(unread, ElementsAre(0x2010, 0x4010, 0x4030, 0x8030, 0xC020, 0x3010));
}

/// The packet is whole and its sums are right, but a record says more bytes than came, or fewer
/// than its header has, or the packet ends within a header.
TEST(Records, ThatDoNotEndWithTheirPacketAreNoMessage) {
  const auto codec = wire::described::DescribedCodec(shipped("mip-imu.toml"));
  for (const Buffer& records : {Buffer{0x0E, 0x05, 0x3E}, Buffer{0x00, 0x05}, Buffer{0x02}}) {
    Buffer frame{0x75, 0x65, 0x80, static_cast<std::uint8_t>(records.size())};
    frame.insert(frame.end(), records.begin(), records.end());
    unsigned a = 0, b = 0;
    for (const unsigned byte : frame) b += a += byte;
    frame.push_back(static_cast<std::uint8_t>(a));
    frame.push_back(static_cast<std::uint8_t>(b));
    EXPECT_EQ(codec.scan(frame), wire::Scan::frame(frame.size()));
    EXPECT_FALSE(codec.decode(frame));
  }
}

TEST(Records, AreReadWithoutAnAllocation) {
  for (const auto& [file, golden] :
       {std::pair("mip-imu.toml", packet("mip.bin", 0, 48)),
        std::pair("xsens-mtdata2.toml", packet("mtdata2.bin", 0, 144))}) {
    Heard heard;
    heard.all.reserve(1000);
    const auto driver = driver_of(shipped(file));
    const device::test::AllocationCount allocations;
    for (int i = 0; i < 100; ++i)
      driver->receive(golden, measurement::stamp_from_ns(i * 10'000'000LL), heard);
    EXPECT_EQ(allocations.so_far(), 0u) << file;
    EXPECT_EQ(heard.all.size(), 100u) << file;
  }
}

// Under way: roll 3, pitch -4, heading 290 degrees.
TEST(Records, OfEmulatedUnitsAreWhatTheTruthIs) {
  for (const char* file : {"mip-attitude.toml", "xsens-mtdata2-attitude.toml"}) {
    Bench bench(file, 10);
    bench.run(2);
    ASSERT_GE(bench.all.size(), 18u) << file;
    const auto& last = std::get<AttitudeSample>(bench.all.back());
    EXPECT_NEAR(last.roll_rad.value() / degree, 3, 1e-4) << file;
    EXPECT_NEAR(last.pitch_rad.value() / degree, -4, 1e-4) << file;
    EXPECT_NEAR(last.true_heading_rad.value() / degree, 290, 1e-4) << file;
  }
  for (const char* file : {"mip-imu.toml", "xsens-mtdata2.toml"}) {
    Bench bench(file, 100);
    bench.run(1);
    ASSERT_GE(bench.all.size(), 98u) << file;
    const auto& imu = std::get<ImuSample>(bench.all.back());
    EXPECT_LT(imu.specific_force.z(), -9.5)
        << file << ": down is positive, and the body is held up";
  }
}

std::string problems_with(const std::string& records, const std::string& field) {
  return problems_of(R"(
[sensor]
title = "x"
[protocol]
checksum = "crc-16/modbus"
[[protocol.binary]]
name = "m"
sync = "AA"
length = { at = 1, type = "u8", plus = 4 }
)" + records + "\nfields = [{ " +
                     field + " }]\n");
}

TEST(Records, ThatCannotBeReadAreRefusedWithTheirPlace) {
  const std::string of_four =
      R"(records = { from = 2, id = { at = 0, type = "u8" }, length = { at = 1, type = "u8" } })";
  const std::string value = R"(record = 5, at = 0, type = "u8", name = "v")";
  EXPECT_EQ(problems_with(of_four, value), "");
  EXPECT_THAT(
      problems_with("", value),
      HasSubstr("toy.toml:11:22: /protocol/binary/0/fields/0: its message has no 'records'"));
  EXPECT_THAT(
      problems_with(
          R"(records = { from = 2, id = { at = 0, type = "u16" }, length = { at = 1, type = "u8" } })",
          value),
      HasSubstr("the id and the length of a record have a byte in common"));
  EXPECT_THAT(problems_with(of_four, R"(record = 5, at = 0, type = "u8", is = 3)"),
              HasSubstr("a constant is in front of the records"));
  EXPECT_THAT(problems_with(of_four, R"(at = 2, type = "u8", name = "v")"),
              HasSubstr("field at 2 is where the records are, which begin at byte 2"));
}

}  // namespace records_test
}  // namespace drydock::described::test

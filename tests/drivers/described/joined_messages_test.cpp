#include <gmock/gmock.h>

#include "tests/drivers/described/driven.hpp"

/// A sample that comes in several messages of a line.
namespace drydock::described::test {
namespace joined_messages_test {

using ::testing::HasSubstr;
using wire::testing::Buffer;

/// WitMotion's protocol: 55h, the kind, three numbers of 16 bits and a temperature, the sum of all.
/// 32768 counts are 16 g, or 2000 degrees a second.
constexpr const char* wit = R"(
[sensor]
title = "WT901"
kind = "imu"
[protocol]
checksum = "sum-8"
[[protocol.binary]]
name = "force"
sync = "55 51"
length = 11
sample = "imu"
fields = [
  { at = 2, type = "i16", field = "force_x_mps2", unit = "g", scale = 0.00048828125 },
  { at = 4, type = "i16", field = "force_y_mps2", unit = "g", scale = 0.00048828125 },
  { at = 6, type = "i16", field = "force_z_mps2", unit = "g", scale = 0.00048828125 },
]
[[protocol.binary]]
name = "rate"
sync = "55 52"
length = 11
sample = "imu"
fields = [
  { at = 2, type = "i16", field = "rate_x_degps", unit = "deg/s", scale = 0.06103515625 },
  { at = 4, type = "i16", field = "rate_y_degps", unit = "deg/s", scale = 0.06103515625 },
  { at = 6, type = "i16", field = "rate_z_degps", unit = "deg/s", scale = 0.06103515625 },
]
)";

// One g down, and 100 degrees a second (1638 counts) about x: sums computed by hand.
const Buffer force{0x55, 0x51, 0x00, 0x00, 0x00, 0x00, 0x00, 0xF8, 0x00, 0x00, 0x9E};
const Buffer rate{0x55, 0x52, 0x66, 0x06, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x13};

std::string text_of(std::initializer_list<Buffer> frames) {
  std::string all;
  for (const Buffer& frame : frames) all.append(frame.begin(), frame.end());
  return all;
}

TEST(JoinedMessages, MakeOneSampleThatIsValidWithTheFirst) {
  auto options = options_of(described(wit));
  options.baud = 9600;
  Heard heard;
  const auto driver = *device::make_byte_driver(options);
  const Stamp end = measurement::stamp_from_ns(1'000'000'000);
  receive(*driver, text_of({force, rate}), end, heard);
  ASSERT_EQ(heard.all.size(), 1u);
  const auto& sample = heard.last<measurement::ImuSample>();
  EXPECT_NEAR(sample.specific_force.z(), -9.80665, 1e-12);
  EXPECT_NEAR(sample.angular_rate.x(), 1638 * 2000.0 / 32768 * M_PI / 180, 1e-12);
  // 22 bytes of 10 bits at 9600 baud.
  EXPECT_NEAR(measurement::seconds(end - sample.origin.valid_at), 220.0 / 9600, 1e-6);
}

TEST(JoinedMessages, AreNotJoinedOverOneThatIsMissing) {
  Heard heard;
  const auto driver = driver_of(described(wit));
  receive(*driver, text_of({rate, force, force, rate, rate, force, rate}), {}, heard);
  EXPECT_EQ(heard.all.size(), 2u);
  EXPECT_EQ(heard.refusals.size(), 3u);
}

std::string without_samples() {
  std::string text = wit;
  for (auto at = text.find("sample = \"imu\"\n"); at != text.npos;
       at = text.find("sample = \"imu\"\n"))
    text.erase(at, 15);
  return text;
}

TEST(JoinedMessages, AnImuWhoseSamplesCanNeverBeWholeIsRefused) {
  const std::string problems = problems_of(without_samples());
  EXPECT_THAT(problems, HasSubstr("/protocol/binary/0: a sample of an IMU has three forces and "
                                  "three rates; this one lacks rate_x_degps rate_y_degps"));
  EXPECT_THAT(problems, HasSubstr("/protocol/binary/1: "));
}

}  // namespace joined_messages_test
}  // namespace drydock::described::test

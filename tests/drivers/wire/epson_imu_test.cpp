#include "drivers/wire/canopen/epson_imu.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::epson {
namespace epson_imu_test {

using cia404_imu::ImuSet;
using test::frame;
using test::text_of;

CanFrame gyro(unsigned counter) {
  auto f = frame("181#0000010002000300");
  f.data[0] = counter & 0xFF;
  f.data[1] = counter >> 8 & 0xFF;
  return f;
}

CanFrame accelerometer(unsigned counter) {
  auto f = gyro(counter);
  f.id = 0x281;
  return f;
}

// The tool's dump of a real G552 contains 7130h:4 = 07B5h; its next line prints 789.2 mg.
TEST(EpsonImu, ScalesAsItsMakersToolDoes) {
  const auto set =
      test::only<ImuSet, EpsonG552>({frame("189#46010000FFFFFEFF"), frame("289#4601B507B4FEE105")});
  EXPECT_EQ(set.node, 9);
  EXPECT_NEAR(*set.specific_force_mps2[0], 0.7892 * 9.80665, 1e-12);
  EXPECT_NEAR(*set.specific_force_mps2[1], -0.1328 * 9.80665, 1e-12);
  EXPECT_NEAR(*set.specific_force_mps2[2], 0.602 * 9.80665, 1e-12);
  EXPECT_NEAR(degrees(*set.rate_radps[1]), -0.01515, 1e-12);
  EXPECT_NEAR(degrees(*set.rate_radps[2]), -0.0303, 1e-12);
}

TEST(EpsonImu, EncodesWhatPythonsStructPacks) {
  const Sample sample{1,
                      20858,
                      {radians(-0.024), radians(-0.112), radians(-0.040)},
                      {0.344 * 9.80665, -0.1542 * 9.80665, -0.9326 * 9.80665}};
  const auto frames = encode(sample, g550);
  EXPECT_EQ(text_of(frames[0]), "181#7A51FDFFF2FFFBFF");
  EXPECT_EQ(text_of(frames[1]), "281#7A51B806FDFCC9ED");
  EXPECT_EQ(text_of(encode(Condition{1, 20858, 273.15 + 24.366770, {}})), "381#7A51F10A");
  EXPECT_EQ(text_of(encode(Condition{1, 20858, 273.15 + 24.366770, 2})), "381#7A51F10A00000200");
}

TEST(EpsonImu, AConditionHasTheStatusOnlyWhereThePdoHoldsIt) {
  EXPECT_EQ((test::only<Condition, EpsonG550>({frame("381#7A51F10A")}).status), std::nullopt);
  EXPECT_EQ((test::only<Condition, EpsonG552>({frame("381#7A51F10A00000200")}).status), 2);
  EXPECT_TRUE(test::decode_all<EpsonG552>({frame("381#7A51F10A0000")}).empty());
}

// The tool's dump of a real G552 contains 2101h:1 = 35E6h and 2101h:2 = 0CE87340h. A moment later
// it prints 20:45:35.175 of 10 October 2021, in a zone 7 h behind UTC.
TEST(EpsonImu, ReadsTheTimeOfTheDeviceInTheOrderOfItsModel) {
  const auto g552 = test::only<DeviceTime, EpsonG552>({frame("489#38014073E80CE635")});
  EXPECT_EQ(g552.node, 9);
  EXPECT_EQ(g552.counter, 0x138);
  EXPECT_EQ(g552.day, 13797 + 1);  // 37 years of 365 days, 10 leap days, 282; midnight passed
  EXPECT_NEAR(*g552.time_of_day_s, (20 + 7 - 24) * 3600 + 45 * 60 + 35.028, 1e-9);
  const auto g550 = test::only<DeviceTime, EpsonG550>({frame("489#3801E6354073E80C")});
  EXPECT_EQ(g550.day, g552.day);
  EXPECT_EQ(g550.time_of_day_s, g552.time_of_day_s);
}

TEST(EpsonImu, ATimeBeyondTheDayIsNone) {
  const auto last = test::only<DeviceTime, EpsonG552>({frame("481#0000F0BF6552E635")});
  EXPECT_NEAR(*last.time_of_day_s, 86'399.999, 1e-9);
  const auto beyond = test::only<DeviceTime, EpsonG552>({frame("481#000000C06552E635")});
  EXPECT_EQ(beyond.time_of_day_s, std::nullopt);
}

TEST(EpsonImu, HoldsWhatDoesNotFitAtTheEndOfTheRange) {
  const Sample fast{1, 0, {radians(400.0), 0, radians(-400.0)}, {0, 0, 0}};
  EXPECT_FALSE(fits(fast, g550));
  EXPECT_TRUE(fits(fast, g552));
  EXPECT_EQ(text_of(encode(fast, g550)[0]), "181#0000FF7F00000080");
}

TEST(EpsonImu, OnlyHalvesOfOneCounterAreJoinedWhicheverIsLost) {
  std::vector<CanFrame> stream;
  for (unsigned i = 0; i < 4; ++i) {
    stream.push_back(gyro(i));
    stream.push_back(accelerometer(i));
  }
  for (std::size_t lost = 0; lost < stream.size(); ++lost) {
    auto frames = stream;
    frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(lost));
    frames.push_back(gyro(4));  // shows a lost last frame
    EpsonG550::Decoder decoder;
    int sets = 0;
    for (const CanFrame& f : frames) sets += decoder.receive(f).has_value();
    EXPECT_EQ(sets, 3) << lost;
    EXPECT_EQ(decoder.counters().bad_checksums, 1u) << lost;
  }
}

TEST(EpsonImu, HalvesMayComeInEitherOrderAndOfTwoNodes) {
  auto other = gyro(7), other_half = accelerometer(7);
  other.id = 0x182, other_half.id = 0x282;
  const auto sets =
      test::decode_all<EpsonG550>({accelerometer(1), other, gyro(1), other_half, gyro(2)});
  ASSERT_EQ(sets.size(), 2u);
  EXPECT_EQ(std::get<ImuSet>(sets[0]).node, 1);
  EXPECT_EQ(std::get<ImuSet>(sets[1]).node, 2);
}

TEST(EpsonImu, TheCounterWraps) {
  const auto sets =
      test::decode_all<EpsonG550>({gyro(65535), accelerometer(65535), gyro(0), accelerometer(0)});
  EXPECT_EQ(sets.size(), 2u);
}

}  // namespace epson_imu_test
}  // namespace drydock::wire::epson

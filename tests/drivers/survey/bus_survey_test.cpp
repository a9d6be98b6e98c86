#include "drivers/survey/bus_survey.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/capture/capture_file.hpp"
#include "drivers/survey/node_names.hpp"
#include "drivers/wire/can/can_bits.hpp"
#include "drivers/wire/canopen/canopen.hpp"

namespace drydock::survey {
namespace bus_survey_test {

using testing::HasSubstr;
using wire::CanFrame;

/// Surveys the frames of a fixture, at their own times.
std::unique_ptr<BusSurvey> hear(const std::string& file) {
  capture::CaptureFile capture(DRYDOCK_SOURCE_DIR "/fixtures/" + file, "", "");
  auto survey = std::make_unique<BusSurvey>();
  while (const auto record = capture.next())
    survey->receive(record->frame, Stamp{record->time.value_or(Stamp::duration{0})});
  return survey;
}

std::vector<std::string> protocols(const std::vector<Node>& nodes) {
  std::vector<std::string> names;
  for (const Node& node : nodes)
    for (const auto& sensor : node.sensors) names.emplace_back(sensor.protocol);
  return names;
}

struct Golden {
  std::string protocol, file;
};
class GoldenBus : public testing::TestWithParam<Golden> {};

TEST_P(GoldenBus, IsFoundAsItself) {
  const auto survey = hear(GetParam().file);
  EXPECT_THAT(protocols(survey->nodes()), testing::Contains(GetParam().protocol));
}

INSTANTIATE_TEST_SUITE_P(Profiles, GoldenBus,
                         testing::Values(Golden{"nmea2000", "nmea2000/frames.log"},
                                         Golden{"aceinna", "aceinna/frames.log"},
                                         Golden{"microstrain-mv5", "microstrain-mv5/frames.log"},
                                         Golden{"sbg", "sbg/frames.log"},
                                         Golden{"cia404-imu", "cia404-imu/frames.log"},
                                         Golden{"epson-g550", "epson-g550/frames.log"},
                                         Golden{"epson-g552", "epson-g552/frames.log"}),
                         [](const auto& golden) {
                           std::string name = golden.param.protocol;
                           std::erase(name, '-');
                           return name;
                         });

TEST(BusSurvey, TwoMakersOfTheSameGroupsAreToldApart) {
  EXPECT_THAT(protocols(hear("microstrain-mv5/frames.log")->nodes()),
              testing::Not(testing::Contains("aceinna")));
  EXPECT_THAT(protocols(hear("aceinna/frames.log")->nodes()),
              testing::Not(testing::Contains("microstrain-mv5")));
}

CanFrame frame(std::uint32_t id, std::initializer_list<std::uint8_t> data, bool extended = false) {
  CanFrame f;
  f.id = id;
  f.extended = extended;
  std::copy(data.begin(), data.end(), f.data.begin());
  f.size = static_cast<std::uint8_t>(data.size());
  return f;
}

TEST(BusSurvey, ATransmittersPressureIsFoundByFramesOfFourOrFiveBytes) {
  BusSurvey survey;  // 100000 Pa, status good: the example of Danfoss's manual
  for (int i = 0; i < 10; ++i)
    survey.receive(frame(0x185, {0xA0, 0x86, 0x01, 0x00, 0x00}),
                   Stamp{} + std::chrono::milliseconds{100} * i);
  const auto nodes = survey.nodes();
  EXPECT_THAT(protocols(nodes), testing::ElementsAre("cia404-pressure"));
  EXPECT_EQ(nodes.at(0).confidence, Confidence::certain);
  EXPECT_NEAR(*nodes.at(0).sensors.at(0).rate_hz, 10, 1e-9);
}

TEST(BusSurvey, ASpeedLogAndAReceiverOfOneBusAreFoundByWhatTheySend) {
  BusSurvey survey;  // frames of real buses in canboat's samples: 2.83 m/s; 34.4 N 133.5 E
  for (int i = 0; i < 10; ++i) {
    const Stamp at = Stamp{} + std::chrono::milliseconds{200} * i;
    survey.receive(frame(0x09F50323, {0xFF, 0x1B, 0x01, 0xFF, 0xFF, 0x00, 0xFF, 0xFF}, true), at);
    survey.receive(frame(0x09F80134, {0x19, 0xEE, 0x81, 0x14, 0xE4, 0xC5, 0x98, 0x4F}, true), at);
  }
  const auto nodes = survey.nodes();
  ASSERT_EQ(nodes.size(), 2U);
  ASSERT_EQ(nodes[0].sensors.size(), 1U);
  ASSERT_EQ(nodes[1].sensors.size(), 1U);
  EXPECT_EQ(nodes[0].sensors[0].kind, device::Kind::emlog);
  EXPECT_EQ(nodes[1].sensors[0].kind, device::Kind::gnss);
  EXPECT_EQ(nodes[1].confidence, Confidence::certain);
}

TEST(BusSurvey, APressureThatNoSeaHasIsNone) {
  BusSurvey survey;
  for (int i = 0; i < 10; ++i)
    survey.receive(frame(0x185, {0xFF, 0xFF, 0xFF, 0x7F, 0x00}), Stamp{});
  EXPECT_TRUE(survey.nodes().at(0).sensors.empty());
}

TEST(BusSurvey, AnXsensIsFoundByItsIdentifiers) {
  BusSurvey survey;  // rate 0, specific force (0, 0, 2509 / 256) m/s2
  for (int i = 0; i < 10; ++i) {
    const Stamp at = Stamp{} + std::chrono::milliseconds{10} * i;
    survey.receive(frame(0x032, {0, 0, 0, 0, 0, 0}), at);
    survey.receive(frame(0x034, {0, 0, 0, 0, 0x09, 0xCD}), at + std::chrono::microseconds{500});
  }
  EXPECT_THAT(protocols(survey.nodes()), testing::ElementsAre("xsens"));
}

TEST(BusSurvey, AnAddressClaimNamesItsSender) {
  // By the positions of the fields in J1939-81: identity 12345, manufacturer 135, function 130,
  // class 60 in bits 49 to 55, industry group 4 (marine), arbitrary address.
  const std::uint64_t name =
      12345ull | 135ull << 21 | 130ull << 40 | 60ull << 49 | 4ull << 60 | 1ull << 63;
  CanFrame claim = frame(0x18EEFF23, {0, 0, 0, 0, 0, 0, 0, 0}, true);
  for (std::size_t i = 0; i < 8; ++i) claim.data[i] = static_cast<std::uint8_t>(name >> 8 * i);
  BusSurvey survey;
  survey.receive(claim, Stamp{});
  const auto nodes = survey.nodes();
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].address, 0x23);
  ASSERT_TRUE(nodes[0].name);
  EXPECT_EQ(in_words(*nodes[0].name), "Airmar, navigation, function 130, serial 12345");
}

TEST(BusSurvey, ACanopenNodeSaysThatItStartedAndHowItIs) {
  BusSurvey survey;
  survey.receive(frame(0x705, {0x00}), Stamp{});
  survey.receive(frame(0x705, {0x7F}), Stamp{});
  survey.receive(frame(0x085, {0x10, 0x81, 0x11, 0, 0, 0, 0, 0}), Stamp{});
  survey.receive(frame(0x585, {0x43, 0x00, 0x10, 0x00, 0x94, 0x01, 0x02, 0x00}), Stamp{});
  const auto nodes = survey.nodes();
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].address, 5);
  EXPECT_TRUE(nodes[0].booted);
  EXPECT_EQ(nodes[0].state, wire::canopen::NodeState::pre_operational);
  EXPECT_EQ(nodes[0].emergency->code, 0x8110);
  EXPECT_EQ(nodes[0].device_type, 0x00020194u);
}

TEST(BusSurvey, ErrorFramesAloneHintAtTheBitRate) {
  BusSurvey survey;
  CanFrame error = frame(0x008, {0, 0, 0, 0, 0, 0, 0, 0});
  error.error = true;
  for (int i = 0; i < 3; ++i) survey.receive(error, Stamp{});
  const auto complaints = survey.complaints();
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_EQ(complaints[0].frames, 3u);
  EXPECT_THAT(bit_rate_hint(complaints, survey.frames()), HasSubstr("bit rate is wrong"));
  EXPECT_THAT(bit_rate_hint({}, 0), HasSubstr("silence"));
  EXPECT_EQ(bit_rate_hint(complaints, 1000), "");
}

TEST(WireBits, OfAFrameOfZerosEveryFifthBitIsFollowedByAStuffBit) {
  // 34 zero bits from the start of frame to the CRC, which is 0: 6 stuff bits. 13 bits follow.
  EXPECT_EQ(wire::wire_bits(frame(0, {})), 34u + 6 + 13);
}

TEST(WireBits, StayWithinWhatTheFormatCanBe) {
  const auto inside = [](const CanFrame& f, unsigned unstuffed, unsigned stuffable) {
    const unsigned bits = wire::wire_bits(f);
    EXPECT_GE(bits, unstuffed);
    EXPECT_LE(bits, unstuffed + (stuffable - 1) / 4);
  };
  // 8 bytes: 111 and 131 bits with the intermission; 98 and 118 of them are subject to stuffing.
  inside(frame(0x555, {0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55}), 111, 98);
  inside(frame(0x7FF, {255, 255, 255, 255, 255, 255, 255, 255}), 111, 98);
  inside(frame(0x15555555, {1, 2, 3, 4, 5, 6, 7, 8}, true), 131, 118);
}

TEST(BusSurvey, TheLoadIsTheBitsOfTheFramesByTheirTime) {
  BusSurvey survey;
  for (int i = 0; i <= 100; ++i)
    survey.receive(frame(0, {}), Stamp{} + std::chrono::milliseconds{10} * i);
  EXPECT_NEAR(*survey.bits_per_second(), 53 * 100, 1e-6);
}

}  // namespace bus_survey_test
}  // namespace drydock::survey

#include "drivers/wire/can/xsens.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::xsens {
namespace xsens_test {

using test::frame;
using test::text_of;

std::array<double, 3> axes_of(const std::string& text) {
  return test::only<Acceleration, Xsens>({frame(text)}).value;
}

// Vectors that others made by hand from the tables of MT1604P (corpora, xsens_vectors.tsv).
TEST(Xsens, DecodesThePublishedVectors) {
  const auto rows = test::lines_of(test::corpus("can_imu/xsens_vectors.tsv"));
  if (rows.empty()) GTEST_SKIP() << "corpora absent: can_imu";
  std::vector<Message> messages;
  for (const std::string& row : rows) {
    if (!std::isdigit(static_cast<unsigned char>(row.front()))) continue;
    const auto tab = row.find('\t');
    const auto data = row.substr(tab + 1, row.find('\t', tab + 1) - tab - 1);
    const auto decoded = test::decode_all<Xsens>({frame(row.substr(0, tab) + "#" + data)});
    ASSERT_EQ(decoded.size(), 1u) << row;
    messages.push_back(decoded[0]);
  }
  ASSERT_EQ(messages.size(), 10u);
  using Axes = std::array<double, 3>;
  EXPECT_EQ(std::get<Acceleration>(messages[0]).value, (Axes{0, 0, 9.80859375}));
  EXPECT_EQ(std::get<Acceleration>(messages[1]).value, (Axes{1.5, -2.25, 9.80859375}));
  EXPECT_EQ(std::get<Acceleration>(messages[2]).value, (Axes{0.00390625, 0, 0}));
  EXPECT_EQ(std::get<RateOfTurn>(messages[3]).value, (Axes{0.099609375, -0.25, 2.5}));
  EXPECT_NEAR(std::get<EulerAngles>(messages[4]).value[0], radians(90.0), 1e-12);
  EXPECT_NEAR(std::get<Quaternion>(messages[5]).wxyz[0], 1, 1e-15);
  EXPECT_NEAR(std::get<Quaternion>(messages[6]).wxyz[0], -1, 1e-15);
  EXPECT_EQ(std::get<SampleTime>(messages[7]).ticks, 1'000'000u);  // 100 s
  EXPECT_EQ(std::get<GroupCounter>(messages[8]).counter, 0x1234);
  EXPECT_EQ(std::get<Error>(messages[9]).code, 1);
}

TEST(Xsens, EncodesThem) {
  EXPECT_EQ(text_of(encode(Acceleration{{1.5, -2.25, 9.81}})), "034#0180FDC009CF");
  EXPECT_EQ(text_of(encode(RateOfTurn{{0.1, -0.25, 2.5}})), "032#0033FF800500");
  EXPECT_EQ(text_of(encode(EulerAngles{{radians(90.0), 0, 0}})), "022#2D0000000000");
  EXPECT_EQ(text_of(encode(Quaternion{{-1, 0, 0, 0}})), "021#8001000000000000");
  EXPECT_EQ(text_of(encode(SampleTime{1'000'000})), "005#000F4240");
  EXPECT_EQ(text_of(encode(GroupCounter{0x1234})), "006#1234");
  EXPECT_EQ(text_of(encode(DeltaV{{0.5, -0.25, 0}, 15})), "031#4000E00000000F");
}

TEST(Xsens, NoRawValueMeansNotAvailable) {
  EXPECT_EQ(axes_of("034#FFFFFFFFFFFF")[0], -0.00390625);
  EXPECT_EQ(axes_of("034#7FFF00000000")[0], 127.99609375);
  EXPECT_EQ(axes_of("034#CF0900000000")[0], -12535 / 256.0);  // little-endian would be +9.81
}

TEST(Xsens, AShortFrameIsRefusedAndPaddingUnread) {
  Xsens::Decoder decoder;
  EXPECT_FALSE(decoder.receive(frame("034#000009CF")));
  EXPECT_FALSE(decoder.receive(frame("032#0200")));
  EXPECT_EQ(decoder.counters().bad_checksums, 2u);
  EXPECT_EQ(axes_of("034#0000000009CFDEAD")[2], 9.80859375);
  EXPECT_FALSE(decoder.receive(frame("100#000000000000")));
  EXPECT_FALSE(decoder.receive(frame("00000034#000000000000")));  // 29 bits were not configured
  EXPECT_EQ(decoder.counters().bad_checksums, 2u);
}

TEST(Xsens, IdentifiersAreAsTheDeviceWasSetUp) {
  Identifiers ids;
  ids.extended = true;
  EXPECT_TRUE(ids.set("acceleration", 0x19FF0034));
  EXPECT_FALSE(ids.set("acc", 1));
  EXPECT_TRUE(ids.sound());
  Xsens::Decoder decoder(ids);
  EXPECT_TRUE(decoder.receive(frame("19FF0034#0000000009CF")));
  EXPECT_FALSE(decoder.receive(frame("034#0000000009CF")));
  EXPECT_EQ(text_of(encode(Acceleration{{0, 0, 9.81}}, ids)), "19FF0034#0000000009CF");
  ids.extended = false;
  EXPECT_FALSE(ids.sound());
  Identifiers twice;
  twice.set("acceleration", 0x32);
  EXPECT_FALSE(twice.sound());
}

TEST(Xsens, AStepThatNoDeviceStatesIsRefused) {
  Xsens::Decoder decoder;
  EXPECT_FALSE(decoder.receive(frame("031#00010001000120")));
}

RC_GTEST_PROP(Xsens, AnyIntegersComeBackTheSame, (std::array<std::int16_t, 3> raw)) {
  CanFrame sent = frame("034#000000000000");
  for (std::size_t i = 0; i < 3; ++i) {
    sent.data[2 * i] = static_cast<std::uint8_t>(raw[i] >> 8);
    sent.data[2 * i + 1] = static_cast<std::uint8_t>(raw[i]);
  }
  RC_ASSERT(encode(test::only<Acceleration, Xsens>({sent})) == sent);
}

}  // namespace xsens_test
}  // namespace drydock::wire::xsens

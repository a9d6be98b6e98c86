#include <cstdio>
#include <fstream>

#include "drivers/wire/described/frame_codec.hpp"
#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "drivers/wire/nmea2000/nmea2000.hpp"
#include "tests/drivers/described/heard_of.hpp"
#include "tests/drivers/device/allocation_count.hpp"
#include "tests/drivers/wire/can_fixture.hpp"
#include "tests/drivers/wire/gpsd_logs.hpp"

/// Compasses: sentences and NMEA 2000 frames read as with the codecs written by hand.
namespace drydock::described::test {
namespace compass_test {

using measurement::AttitudeSample;
using measurement::HeadingReference;
using namespace wire::testing;

constexpr double degree = emulate::degree;

TEST(DescribedCompass, SentencesGiveTheHeadingWithItsReference) {
  const auto heard = heard_of_fixture("nmea-heading.toml", "nmea-heading.txt");
  ASSERT_EQ(heard.all.size(), 7u);
  const auto& hdt = heard.at<AttitudeSample>(0);
  EXPECT_EQ(hdt.reference, HeadingReference::true_north);
  EXPECT_NEAR(hdt.true_heading_rad.value(), 75.5664 * degree, 1e-12);
  EXPECT_NEAR(heard.at<AttitudeSample>(1).heading_rad.value(), 244.17 * degree, 1e-12);
  EXPECT_FALSE(heard.at<AttitudeSample>(2).heading_rad) << "mode V";
  const auto& east = heard.at<AttitudeSample>(3);
  EXPECT_EQ(east.reference, HeadingReference::magnetic_north);
  EXPECT_NEAR(east.heading_rad.value(), 229.8 * degree, 1e-12);
  EXPECT_NEAR(east.true_heading_rad.value(), 231.1 * degree, 1e-12);
  const auto& west = heard.at<AttitudeSample>(4);
  EXPECT_NEAR(west.deviation_rad.value(), -0.5 * degree, 1e-12);
  EXPECT_NEAR(west.true_heading_rad.value(), 85.2 * degree, 1e-12);  // 98.3 - 0.5 - 12.6
  EXPECT_FALSE(heard.at<AttitudeSample>(5).true_heading_rad) << "no variation";
  EXPECT_NEAR(heard.at<AttitudeSample>(6).heading_rad.value(), 218.634 * degree, 1e-12);
}

/// The heading, its reference and variation of each HDG, HDM, HDT and THS of gpsd's logs.
TEST(DescribedCompass, TheDescriptionReadsAllHeadingsOfGpsdsLogsAsTheCodecWrittenByHand) {
  if (!std::filesystem::exists(corpora())) GTEST_SKIP() << "no corpora";
  const auto described = shipped("nmea-heading.toml");
  const auto equal = [](const std::optional<double>& a, const std::optional<double>& b) {
    return a.has_value() == b.has_value() && (!a || std::abs(*a - *b) < 1e-12);
  };
  std::size_t compared = 0;
  for (const auto& log : gpsd_logs()) {
    wire::Framer<1024> framer;
    framer.feed(gpsd_log(log), wire::Nmea0183::scan, [&](wire::Bytes frame, std::size_t) {
      const auto message = wire::Nmea0183::decode(frame);
      if (!message) return;
      wire::described::Record record;
      wire::described::Readings r;
      using enum wire::described::Target;
      const bool ours = wire::described::decode(described->plan, frame, record) ==
                        wire::described::Decoded::message;
      if (ours) read(record, r);
      const auto same = [&](const auto& of, auto target, const std::optional<double>& value) {
        EXPECT_TRUE(ours && equal(r.get(target), value)) << of << " " << as_text(frame);
        ++compared;
      };
      if (const auto* m = std::get_if<wire::Hdt>(&*message)) same("HDT", heading, m->heading_rad);
      if (const auto* m = std::get_if<wire::Ths>(&*message)) same("THS", heading, m->heading_rad);
      if (const auto* m = std::get_if<wire::Hdm>(&*message))
        same("HDM", magnetic_heading, m->heading_rad);
      if (const auto* m = std::get_if<wire::Hdg>(&*message)) {
        same("HDG", magnetic_heading, m->sensor_heading_rad);
        same("variation", variation, m->variation_rad);
      }
    });
  }
  EXPECT_EQ(compared, 9u + 9u + 7u + 2 * 1457u) << "counted by a regular expression elsewhere";
}

TEST(DescribedCompass, WhatNoCompassSaysIsRefusedAndTold) {
  const auto heard = heard_of("nmea-heading.toml", "$HEHDT,361.5,T*2E\r\n$HCHDM,12,M*04\r\n");
  EXPECT_EQ(heard.all.size(), 1u);
  ASSERT_EQ(heard.refusals.size(), 1u);
}

TEST(DescribedCompass, NoTelegramAllocates) {
  for (const auto& [file, golden] : {std::pair("hnav-attitude.toml", "hnav.bin"),
                                     std::pair("stdbin-attitude.toml", "stdbin.bin")}) {
    Heard heard;
    heard.all.reserve(1000);
    const auto driver = driver_of(shipped(file));
    const Buffer bytes = fixture(std::string("described/") + golden);
    const device::test::AllocationCount allocations;
    for (int i = 0; i < 100; ++i)
      driver->receive(bytes, measurement::stamp_from_ns(i * 1'000'000'000LL), heard);
    EXPECT_EQ(allocations.so_far(), 0u) << file;
    EXPECT_GE(heard.all.size(), 300u);
  }
}

/// The same frames for the driver written by hand and for that of the description.
struct TwoDrivers {
  TwoDrivers() {
    auto options = options_of(shipped("n2k-compass-dbc.toml"));
    described = *device::make_frame_driver(options);
    options.description = nullptr;
    options.protocol = "nmea2000";
    by_hand = *device::make_frame_driver(options);
  }
  void says(const std::string& text, double at_s) {
    const auto frame = wire::test::frame(text);
    const Stamp at{measurement::from_seconds(at_s)};
    described->receive(frame, at, of_description);
    by_hand->receive(frame, at, of_hand);
  }
  std::unique_ptr<device::FrameDriver> described, by_hand;
  Heard of_description, of_hand;
};

// The frames of attitude_driver_test.cpp: canboat's field tables by hand.
TEST(DescribedCompass, FramesOfNmea2000ReadAsWithTheDriverWrittenByHand) {
  TwoDrivers both;
  both.says("09F11227#003930FF7FFF7FFC", 1);    // 1.2345 rad true
  both.says("09F11227#0030F29CFFB004FD", 1.1);  // 6.2 rad magnetic, -0.01, 0.12
  both.says("09F11227#001027FF7FFF7FFD", 1.2);  // 1 rad magnetic alone
  both.says("0DF11927#00FF7FC80018FCFF", 1.3);  // pitch 0.02, roll -0.1
  both.says("09F11327#000096E7FFFFFFFF", 1.4);  // -0.05 rad/s
  ASSERT_EQ(both.of_hand.all.size(), 5u);
  ASSERT_EQ(both.of_description.all.size(), 5u);
  const auto near = [](const std::optional<double>& a, const std::optional<double>& b) {
    return a.has_value() == b.has_value() && (!a || std::abs(*a - *b) < 1e-9);
  };
  for (std::size_t i = 0; i < 5; ++i) {
    const auto& a = both.of_description.at<AttitudeSample>(i);
    const auto& b = both.of_hand.at<AttitudeSample>(i);
    EXPECT_EQ(a.reference, b.reference) << i;
    EXPECT_TRUE(near(a.heading_rad, b.heading_rad) &&
                near(a.true_heading_rad, b.true_heading_rad) &&
                near(a.deviation_rad, b.deviation_rad) && near(a.variation_rad, b.variation_rad) &&
                near(a.roll_rad, b.roll_rad) && near(a.pitch_rad, b.pitch_rad) &&
                near(a.rate_of_turn_radps, b.rate_of_turn_radps))
        << i;
  }
  EXPECT_NEAR(both.of_description.at<AttitudeSample>(1).true_heading_rad.value(), 0.026814692820414,
              1e-9);
}

/// "time,priority,pgn,source,destination,8,hex,...": a frame. Empty: another PGN or length.
std::optional<wire::CanFrame> compass_frame(const std::string& line) {
  unsigned priority = 0, pgn = 0, source = 0;
  std::array<unsigned, 8> data{};
  const auto comma = line.find(',');
  if (comma == line.npos ||
      std::sscanf(line.c_str() + comma, ",%u,%u,%u,255,8,%x,%x,%x,%x,%x,%x,%x,%x", &priority, &pgn,
                  &source, &data[0], &data[1], &data[2], &data[3], &data[4], &data[5], &data[6],
                  &data[7]) != 11)
    return {};
  if (pgn != 127250 && pgn != 127251 && pgn != 127257) return {};
  wire::CanFrame frame;
  frame.id = priority << 26 | pgn << 8 | source;
  frame.extended = true;
  frame.size = 8;
  std::ranges::copy(data, frame.data.begin());
  return frame;
}

/// A Raymarine EV-1 and a Furuno: every frame of a heading, a tilt or a rate of turn.
TEST(DescribedCompass, EveryFrameOfRealCompassesReadsAsWithTheCodecWrittenByHand) {
  const auto folder = wire::test::corpus("n2k/canboat/samples");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no corpora";
  wire::described::FrameDecoder described(shipped("n2k-compass-dbc.toml"));
  wire::Nmea2000::Decoder by_hand;
  wire::described::Record record;
  wire::described::Readings r;
  using enum wire::described::Target;
  const auto same = [&](auto target, const std::optional<double>& value) {
    const auto ours = r.get(target);
    EXPECT_EQ(ours.has_value(), value.has_value());
    if (ours && value) {
      EXPECT_NEAR(*ours, *value, 1e-9);
    }
  };
  std::size_t compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    for (const auto& line : wire::test::lines_of(entry.path().string())) {
      const auto frame = compass_frame(line);
      if (!frame) continue;
      ++compared;
      ASSERT_EQ(described.take(*frame, record), wire::described::Taken::message) << line;
      read(record, r);
      const auto message = by_hand.receive(*frame).value();
      if (const auto* m = std::get_if<wire::nmea2000::VesselHeading>(&message)) {
        same(heading, m->heading_rad);
        same(deviation, m->deviation_rad);
        same(variation, m->variation_rad);
        same(heading_reference, m->reference);
      }
      if (const auto* m = std::get_if<wire::nmea2000::RateOfTurn>(&message))
        same(rate_of_turn, m->rate_radps);
      if (const auto* m = std::get_if<wire::nmea2000::Attitude>(&message)) {
        same(roll, m->roll_rad);
        same(pitch, m->pitch_rad);
      }
    }
  EXPECT_EQ(compared, 5446u) << "counted by grep";
}

}  // namespace compass_test
}  // namespace drydock::described::test

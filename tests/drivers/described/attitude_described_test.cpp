#include <cstdio>
#include <fstream>

#include "drivers/wire/described/frame_codec.hpp"
#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "drivers/wire/nmea2000/nmea2000.hpp"
#include "tests/drivers/described/driven.hpp"
#include "tests/drivers/device/allocation_count.hpp"
#include "tests/drivers/wire/can_fixture.hpp"
#include "tests/drivers/wire/gpsd_logs.hpp"

/// Compasses, navigation units and their positions from descriptions.
namespace drydock::described::test {
namespace attitude_described_test {

using measurement::AttitudeSample;
using measurement::BottomVelocity;
using measurement::DepthSample;
using measurement::GnssFix;
using measurement::HeadingReference;
using namespace wire::testing;

constexpr double degree = emulate::degree;

Heard heard_of(const std::string& description, const std::string& stream) {
  Heard heard;
  receive(*driver_of(shipped(description)), stream, {}, heard);
  return heard;
}

Heard heard_of_fixture(const std::string& description, const std::string& file) {
  const Buffer bytes = fixture("described/" + file);
  return heard_of(description, std::string(bytes.begin(), bytes.end()));
}

template <class Sample>
const Sample& sample(const Heard& heard, std::size_t i) {
  return std::get<Sample>(heard.all.at(i));
}

TEST(DescribedCompass, SentencesGiveTheHeadingWithItsReference) {
  const auto heard = heard_of_fixture("nmea-heading.toml", "nmea-heading.txt");
  ASSERT_EQ(heard.all.size(), 7u);
  const auto& hdt = sample<AttitudeSample>(heard, 0);
  EXPECT_EQ(hdt.reference, HeadingReference::true_north);
  EXPECT_NEAR(hdt.true_heading_rad.value(), 75.5664 * degree, 1e-12);
  EXPECT_NEAR(sample<AttitudeSample>(heard, 1).heading_rad.value(), 244.17 * degree, 1e-12);
  EXPECT_FALSE(sample<AttitudeSample>(heard, 2).heading_rad) << "mode V";
  const auto& east = sample<AttitudeSample>(heard, 3);
  EXPECT_EQ(east.reference, HeadingReference::magnetic_north);
  EXPECT_NEAR(east.heading_rad.value(), 229.8 * degree, 1e-12);
  EXPECT_NEAR(east.true_heading_rad.value(), 231.1 * degree, 1e-12);
  const auto& west = sample<AttitudeSample>(heard, 4);
  EXPECT_NEAR(west.deviation_rad.value(), -0.5 * degree, 1e-12);
  EXPECT_NEAR(west.true_heading_rad.value(), 85.2 * degree, 1e-12);  // 98.3 - 0.5 - 12.6
  EXPECT_FALSE(sample<AttitudeSample>(heard, 5).true_heading_rad) << "no variation";
  EXPECT_NEAR(sample<AttitudeSample>(heard, 6).heading_rad.value(), 218.634 * degree, 1e-12);
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

// The public sample: status 8A, hybrid; altitude and temperature bad.
TEST(DescribedHnav, TheSampleOfItsMakerReadsAsItsDecoderSays) {
  const auto attitude = heard_of_fixture("hnav-attitude.toml", "hnav.bin");
  ASSERT_EQ(attitude.all.size(), 3u);
  const auto& first = sample<AttitudeSample>(attitude, 0);
  EXPECT_NEAR(first.true_heading_rad.value() / degree, 72.88, 0.005);  // 72.97 with .0055 a count
  EXPECT_LT(std::abs(first.roll_rad.value()) / degree, 1);
  const auto position = heard_of_fixture("hnav-position.toml", "hnav.bin");
  const auto& fix = sample<GnssFix>(position, 0);
  EXPECT_NEAR(fix.position->latitude_rad / degree, 51.33064, 5e-6);
  EXPECT_NEAR(fix.position->longitude_rad / degree, -0.83569, 5e-6);
  // CEP50 1.9952 m is 1.1774 sigma of each axis (Rayleigh).
  EXPECT_NEAR(*fix.horizontal_accuracy_m, 1.9952174 / 1.1774100 * std::numbers::sqrt2, 1e-5);
  const auto depth = heard_of_fixture("hnav-depth.toml", "hnav.bin");
  EXPECT_NEAR(sample<DepthSample>(depth, 0).depth_m.value(), -0.135, 1e-9);
}

TEST(DescribedHnav, ATelegramGivesWhatItsStatusDoesNotCallBad) {
  const auto attitude = heard_of_fixture("hnav-attitude.toml", "hnav.bin");
  const auto& second = sample<AttitudeSample>(attitude, 1);
  EXPECT_NEAR(second.roll_rad.value() / degree, -1.5, 0.003);
  EXPECT_NEAR(second.pitch_rad.value() / degree, 2.25, 0.003);
  EXPECT_NEAR(second.true_heading_rad.value() / degree, 359, 0.003);
  EXPECT_EQ(second.origin.device_time, std::chrono::seconds{1'700'000'000});
  EXPECT_FALSE(sample<AttitudeSample>(attitude, 2).heading_rad);
  const auto position = heard_of_fixture("hnav-position.toml", "hnav.bin");
  EXPECT_NEAR(sample<GnssFix>(position, 1).position->latitude_rad / degree, -33.5, 1e-7);
  EXPECT_NEAR(sample<GnssFix>(position, 1).position->longitude_rad / degree, 151.25, 1e-7);
  EXPECT_FALSE(sample<GnssFix>(position, 2).position);
  const auto velocity = heard_of_fixture("hnav-velocity.toml", "hnav.bin");
  EXPECT_LT(
      (*sample<BottomVelocity>(velocity, 1).velocity - Eigen::Vector3d(2, 0.123, -0.045)).norm(),
      1e-12);
  EXPECT_FALSE(sample<BottomVelocity>(velocity, 2).velocity);
  const auto depth = heard_of_fixture("hnav-depth.toml", "hnav.bin");
  EXPECT_NEAR(sample<DepthSample>(depth, 1).depth_m.value(), 20.5, 1e-12);
  EXPECT_FALSE(sample<DepthSample>(depth, 2).depth_m);
}

TEST(DescribedStdbin, EveryVersionGivesItsAttitudeWithTheBowUp) {
  const auto heard = heard_of_fixture("stdbin-attitude.toml", "stdbin.bin");
  ASSERT_EQ(heard.all.size(), 4u) << "the last telegram has no attitude";
  const double expected[4][3] = {
      {123.5, -1.25, -2.5}, {359.75, 0.5, 0.25}, {10, 20, 30}, {45, 1, -1}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(sample<AttitudeSample>(heard, i).true_heading_rad.value() / degree, expected[i][0],
                1e-5);
    EXPECT_NEAR(sample<AttitudeSample>(heard, i).roll_rad.value() / degree, expected[i][1], 1e-5);
    EXPECT_NEAR(sample<AttitudeSample>(heard, i).pitch_rad.value() / degree, expected[i][2], 1e-5);
  }
}

TEST(DescribedStdbin, APositionKeepsTheReferenceOfItsHeight) {
  const auto heard = heard_of_fixture("stdbin-position.toml", "stdbin.bin");
  ASSERT_EQ(heard.all.size(), 2u);
  const auto& ellipsoid = sample<GnssFix>(heard, 0);
  EXPECT_NEAR(ellipsoid.position->latitude_rad / degree, 43.25, 1e-12);
  EXPECT_NEAR(ellipsoid.position->longitude_rad / degree, -5.5, 1e-12) << "354.5 of 360";
  EXPECT_DOUBLE_EQ(ellipsoid.ellipsoidal_height_m.value(), 12.5);
  const auto& geoid = sample<GnssFix>(heard, 1);
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
      const auto& fix = sample<GnssFix>(heard, 0);
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

// Under way: roll 3, pitch -4, heading 290 degrees; the position of the truth.
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
    const auto& a = sample<AttitudeSample>(both.of_description, i);
    const auto& b = sample<AttitudeSample>(both.of_hand, i);
    EXPECT_EQ(a.reference, b.reference) << i;
    EXPECT_TRUE(near(a.heading_rad, b.heading_rad) &&
                near(a.true_heading_rad, b.true_heading_rad) &&
                near(a.deviation_rad, b.deviation_rad) && near(a.variation_rad, b.variation_rad) &&
                near(a.roll_rad, b.roll_rad) && near(a.pitch_rad, b.pitch_rad) &&
                near(a.rate_of_turn_radps, b.rate_of_turn_radps))
        << i;
  }
  EXPECT_NEAR(sample<AttitudeSample>(both.of_description, 1).true_heading_rad.value(),
              0.026814692820414, 1e-9);
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

}  // namespace attitude_described_test
}  // namespace drydock::described::test

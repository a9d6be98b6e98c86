#include "drivers/wire/dvl/water_linked.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::wire::testing {
namespace water_linked_test {

using namespace std::chrono_literals;
namespace wl = water_linked;

/// The sentences of fixtures/water-linked/make_golden.py.
template <class M>
M golden(std::size_t index = 0) {
  static const Buffer stream = fixture("water-linked/golden.txt");
  // Texts point into the stream, so the test decodes the stream in place.
  std::vector<M> found;
  Framer<WaterLinked::max_frame> framer;
  framer.feed(stream, WaterLinked::scan, [&](Bytes frame, std::size_t) {
    const auto message = WaterLinked::decode(frame);
    if (const M* m = message ? std::get_if<M>(&*message) : nullptr) found.push_back(*m);
  });
  return found.at(index);
}

TEST(WaterLinked, TheCheckValueOfTheCrc) { EXPECT_EQ(wl::crc8("123456789"), 0xF4); }

TEST(WaterLinked, VelocityForwardStarboardDownWithItsOwnTimes) {
  const auto m = golden<wl::BottomVelocity>();
  EXPECT_TRUE(m.valid);
  EXPECT_EQ(m.velocity_mps, (wl::Velocity{1.234, -0.056, 0.078}));
  EXPECT_EQ(m.altitude_m, 6.98);
  EXPECT_EQ(m.figure_of_merit_mps, 0.003);
  EXPECT_EQ(m.covariance[0], 2.5e-6);
  EXPECT_EQ(m.covariance[2], -3e-8);
  EXPECT_EQ(m.covariance[8], 1e-6);
  EXPECT_EQ(m.validity, 1795262400123456us);
  EXPECT_EQ(*m.transmission - *m.validity, 75309us);
  EXPECT_DOUBLE_EQ(*m.interval_s, 0.0834);
  EXPECT_FALSE(m.hot);
}

TEST(WaterLinked, WithoutLockThereIsNoVelocityNorAltitude) {
  const auto m = golden<wl::BottomVelocity>(1);
  EXPECT_FALSE(m.valid);
  EXPECT_FALSE(m.velocity_mps[0] || m.velocity_mps[1] || m.velocity_mps[2]);
  EXPECT_FALSE(m.altitude_m);
  EXPECT_FALSE(m.covariance[0]) << "one of nine covariances";
  EXPECT_EQ(m.validity, 1795262400223456us) << "fields behind a short covariance";
  EXPECT_TRUE(m.hot);
}

TEST(WaterLinked, WaterTrackIsToldByItsFields) {
  const auto m = golden<wl::WaterVelocity>();
  EXPECT_EQ(m.velocity_mps[0], 0.5);
  EXPECT_EQ(m.figure_of_merit_mps, 0.015);
  EXPECT_THROW(golden<wl::WaterVelocity>(1), std::out_of_range) << "the time status";
}

TEST(WaterLinked, OldFormsWithAndWithoutStatus) {
  const auto m = golden<wl::OldVelocity>();
  EXPECT_EQ(m.velocity_mps, (wl::Velocity{1.234, -0.056, 0.078}));
  EXPECT_EQ(m.altitude_m, 6.98);
  EXPECT_EQ(m.hot, false);
  const auto oldest = golden<wl::OldVelocity>(1);
  EXPECT_FALSE(oldest.valid || oldest.velocity_mps[0] || oldest.altitude_m || oldest.hot);
  EXPECT_DOUBLE_EQ(*oldest.interval_s, 0.125);
  const auto ranges = golden<wl::OldRanges>();
  EXPECT_EQ(ranges.distance_m[3], 7.70);
  EXPECT_FALSE(ranges.distance_m[2]);
}

TEST(WaterLinked, ATransducerWithoutEchoHasNoVelocity) {
  EXPECT_EQ(golden<wl::Transducer>().velocity_mps, 0.412);
  EXPECT_EQ(golden<wl::Transducer>().distance_m, 7.61);
  const auto deaf = golden<wl::Transducer>(1);
  EXPECT_EQ(deaf.id, 2);
  EXPECT_FALSE(deaf.velocity_mps || deaf.distance_m);
  EXPECT_EQ(deaf.rssi_dbm, -92);
  EXPECT_EQ(deaf.noise_dbm, -87);
}

TEST(WaterLinked, DeadReckoning) {
  const auto m = golden<wl::DeadReckoning>();
  EXPECT_EQ(m.time_s, 1795262400.25);
  EXPECT_EQ(m.position_m[1], -3.25);
  EXPECT_EQ(m.position_deviation_m, 0.12);
  EXPECT_NEAR(degrees(*m.yaw_rad), 178, 1e-12);
  EXPECT_TRUE(m.trouble);
}

TEST(WaterLinked, TheDialogue) {
  EXPECT_EQ(golden<wl::Version>().minor, 7);
  EXPECT_EQ(golden<wl::Product>().name, "dvl-a50");
  EXPECT_EQ(golden<wl::Product>().ip_address, "10.11.12.140");
  EXPECT_EQ(golden<wl::Configuration>().sound_speed_mps, 1475.5);
  EXPECT_NEAR(degrees(*golden<wl::Configuration>().mounting_rotation_rad), 20.25, 1e-12);
  EXPECT_EQ(golden<wl::Configuration>().range_mode, "auto");
  using enum wl::Verdict;
  const std::array verdicts{done, refused, not_understood, bad_checksum};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(golden<wl::Answer>(i).verdict, verdicts[i]);
  EXPECT_EQ(golden<wl::Command>().letter, 's');
  EXPECT_EQ(golden<wl::Command>(1).letter, 'p');
  EXPECT_EQ(golden<wl::Command>(1).options, "3");
  EXPECT_EQ(golden<wl::Command>(2).letter, 'v');
}

TEST(WaterLinked, BlankParametersLeaveASettingAsItIs) {
  const auto asked = wl::read_configuration(golden<wl::Command>().options);
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->sound_speed_mps, 1450);
  EXPECT_EQ(asked->acoustic_enabled, false);
  EXPECT_FALSE(asked->mounting_rotation_rad || asked->dark_mode || asked->periodic_cycling);
  EXPECT_TRUE(wl::read_configuration("1450,,n,")) << "four parameters are enough";
  EXPECT_FALSE(wl::read_configuration("1450,,n"));
  EXPECT_FALSE(wl::read_configuration("1450,,perhaps,,,"));
  EXPECT_FALSE(wl::read_configuration("fast,,,,,"));
}

TEST(WaterLinked, TheEncoderRebuildsTheGoldenSentences) {
  const Buffer golden_text = fixture("water-linked/golden.txt");
  const std::string_view text = as_text(golden_text);
  const auto expect_written = [&](const auto& message) {
    std::array<std::uint8_t, 512> out;
    const auto line = as_text(Bytes{out.data(), encode(message, out)});
    EXPECT_NE(text.find(line), text.npos) << line;
    EXPECT_EQ(encode(message, std::span{out}.first(line.size() - 1)), 0u);
  };
  expect_written(golden<wl::Transducer>());
  expect_written(golden<wl::OldVelocity>());
  expect_written(golden<wl::OldRanges>());
  expect_written(golden<wl::Version>());
  expect_written(golden<wl::Product>());
  expect_written(golden<wl::Configuration>());
  for (std::size_t i = 0; i < 4; ++i) expect_written(golden<wl::Answer>(i));
  expect_written(golden<wl::Command>());
}

TEST(WaterLinked, AWrittenVelocityReadsAsItWas) {
  const auto m = golden<wl::BottomVelocity>();
  std::array<std::uint8_t, 512> out;
  const auto read = WaterLinked::decode(Bytes{out.data(), encode(m, out)});
  ASSERT_TRUE(read);
  const auto& again = std::get<wl::BottomVelocity>(*read);
  EXPECT_EQ(again.velocity_mps, m.velocity_mps);
  EXPECT_EQ(again.validity, m.validity);
  EXPECT_EQ(again.transmission, m.transmission);
  EXPECT_EQ(again.altitude_m, m.altitude_m);
  EXPECT_EQ(again.covariance, m.covariance);
}

/// Sentences from the vendor's documents and programs. Columns: verdict, source, sentence, comment.
TEST(WaterLinked, VectorsOfTheVendorAreReadAndTheBadOnesRefused) {
  const auto file = corpora() / "dvl/waterlinked/wl_serial_vectors.txt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no captures at " << corpora();
  const Buffer bytes = read_file(file);
  std::istringstream lines{std::string{as_text(bytes)}};
  std::size_t good = 0, bad = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("crc_")) continue;
    std::istringstream columns{line};
    std::string verdict, source, sentence;
    columns >> verdict >> source >> sentence;
    const auto reading = read_stream<WaterLinked>(as_bytes(sentence + "\r\n"));
    const bool sound = verdict == "crc_ok";
    EXPECT_EQ(reading.messages.size(), sound ? 1u : 0u) << sentence;
    EXPECT_EQ(reading.counters.bad_checksums, sound ? 0u : 1u) << sentence;
    ++(sound ? good : bad);
  }
  EXPECT_GT(good, 0u);
  EXPECT_GT(bad, 0u);
}

TEST(WaterLinked, ATornLineWhoseCrcHappensToFitTheNextOneHidesNothing) {
  const std::string torn = "wrs,0.500,0.010,-0.020,y,0.015,2.5e-06;1e-07;-3e-0";
  const std::string whole = "wru,0,0.412,7.61,-38,-86*9b\r\n";
  const auto text = (torn + whole).substr(0, torn.size() + whole.find('*'));
  ASSERT_EQ(water_linked::crc8(text), 0x9b);
  const auto reading = read_stream<WaterLinked>(as_bytes(torn + whole));
  ASSERT_EQ(reading.frames.size(), 1u);
  EXPECT_EQ(reading.frames[0], as_bytes(whole));
  EXPECT_EQ(reading.counters.bytes_skipped, torn.size());
}

}  // namespace water_linked_test
}  // namespace drydock::wire::testing

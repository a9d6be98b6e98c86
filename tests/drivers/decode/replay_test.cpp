#include "drivers/decode/replay.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/drivers/decode/captured.hpp"

namespace drydock::decode {
namespace replay_test {

using nlohmann::json;
using testing::HasSubstr;
using testing::MatchesRegex;

Decoded run_replay(const ReplayOptions& options) {
  MemoryFile out, err;
  Decoded result;
  result.exit_code = replay(options, out.file(), err.file());
  result.out = out.text();
  result.err = err.text();
  return result;
}

// NMEA 2000 pressure (130314): source 35, instance 0, water, 1511775 of 0.1 Pa. That is 5 m below
// the surface of sea water with 1025 kg/m3 at 9.80665 m/s2 and 101325 Pa. By hand: (151177.5 Pa -
// 101325 Pa) / (rho g) = 4.9596 m.
constexpr std::string_view log =
    "(1700000000.000000) can0 19FD0A23#0100015F111700FF\n"
    "torn\n"
    "(1700000000.500000) can0 19FD0A23#0200015F111700FF\n";

ReplayOptions options_for(const TemporaryFile& file) {
  ReplayOptions options;
  options.capture = file.path();
  options.protocol = "nmea2000";
  options.kind = "depth";
  return options;
}

Decoded run_replay_of_pd0(const std::string& stream) {
  const TemporaryFile file(stream);
  ReplayOptions options;
  options.capture = file.path();
  options.protocol = "pd0";
  options.kind = "dvl";
  options.format = "raw";
  options.baud = 115'200;
  return run_replay(options);
}

TEST(Replay, ACaptureGoesThroughTheDriverAndKeepsItsTimes) {
  const TemporaryFile file(log);
  const Decoded result = run_replay(options_for(file));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto lines = result.lines();
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0]["type"], "depth");
  EXPECT_EQ(lines[0]["received_at_s"], 1700000000.0);
  EXPECT_EQ(lines[1]["received_at_s"], 1700000000.5);
  EXPECT_NEAR(lines[0]["pressure_pa"].get<double>(), 151177.5, 1e-6);
  EXPECT_NEAR(lines[0]["depth_m"].get<double>(), 4.9596, 1e-3);
  EXPECT_TRUE(lines[0]["temperature_k"].is_null());
  EXPECT_THAT(result.err, HasSubstr("2 measurements"));
  EXPECT_THAT(result.err, HasSubstr("1 line or block not understood: 2"));
}

/// No format tells the rate of the bus. The same bits take twice the time at half the rate.
TEST(Replay, TheTimeOfAFrameOnTheBusIsThatOfTheRateThatIsTold) {
  const TemporaryFile file(log);
  const auto age_us = [&](unsigned bitrate, unsigned of_a_rig = 250'000) {
    ReplayOptions options = options_for(file);
    options.bitrate = bitrate;
    options.driver.emplace().bitrate = of_a_rig;
    const auto lines = run_replay(options).lines();
    return (lines.at(0)["received_at_s"].get<double>() - lines.at(0)["valid_at_s"].get<double>()) *
           1e6;
  };
  const double at_250k = age_us(0);
  EXPECT_NEAR(at_250k, 4 * 140, 4 * 14);  // 125 bits and some stuff bits
  EXPECT_NEAR(age_us(500'000), at_250k / 2, 0.5);
  EXPECT_NEAR(age_us(0, 500'000), at_250k / 2, 0.5) << "the rig's rate";
  EXPECT_NEAR(age_us(1'000'000, 500'000), at_250k / 4, 0.5) << "what is told comes first";
}

/// The first ensemble of the file claims 4096 bytes more than it has, and the file ends before
/// them.
TEST(Replay, TheEndOfAFileGivesTheEnsemblesBehindADamagedLength) {
  std::ifstream golden(DRYDOCK_SOURCE_DIR "/fixtures/pd0/golden.pd0", std::ios::binary);
  std::string stream{std::istreambuf_iterator<char>(golden), {}};
  const auto whole = run_replay_of_pd0(stream);
  ASSERT_GT(whole.lines().size(), 1u);
  stream.at(3) = static_cast<char>(stream[3] ^ 0x10);
  const auto damaged = run_replay_of_pd0(stream);
  ASSERT_EQ(damaged.lines().size(), whole.lines().size() - 1);
  for (std::size_t i = 0; i < damaged.lines().size(); ++i)
    EXPECT_EQ(damaged.lines()[i], whole.lines()[i + 1]);
}

Decoded run_replay_of_dvl(const std::string& protocol, std::string_view text) {
  const TemporaryFile file(text);
  ReplayOptions options;
  options.capture = file.path();
  options.protocol = protocol;
  options.kind = "dvl";
  return run_replay(options);
}

/// Times in the sentences: valid at .0, .2 and .4 s, sent 150, 90 and 200 ms later.
constexpr std::string_view wrz =
    "wrz,0.120,-0.400,2.000,y,1.30,1.855,1e-07;0;1.4;0;1.2;0;0.2;0;1e+09,1700000000000000,"
    "1700000000150000,123.00,0*75\r\n"
    "wrz,0.120,-0.400,2.000,y,1.30,1.855,1e-07;0;1.4;0;1.2;0;0.2;0;1e+09,1700000000200000,"
    "1700000000290000,123.00,0*05\r\n"
    "wrz,0.120,-0.400,2.000,y,1.30,1.855,1e-07;0;1.4;0;1.2;0;0.2;0;1e+09,1700000000400000,"
    "1700000000600000,123.00,0*1f\r\n";

/// Trigger at .1234 s, the echo 23.961 ms behind it, the sentence 48.122 ms behind the echo.
constexpr std::string_view pnorbt7 =
    "$PNORBT7,1700000000.1234,23.961,-48.122,0.50000,0.20000,-0.01000,0.00500,23.00,23.10,23.20,23."
    "30*23\r\n"
    "$PNORBT7,1700000001.1234,23.961,-48.122,0.50000,0.20000,-0.01000,0.00500,23.00,23.10,23.20,23."
    "30*22\r\n"
    "$PNORBT7,1700000002.1234,23.961,-48.122,0.50000,0.20000,-0.01000,0.00500,23.00,23.10,23.20,23."
    "30*21\r\n";

/// The diagonal of the golden report's covariance is 2.5e-6, 4e-6 and 1e-6 (m/s)2 (its generator).
TEST(Replay, TellsHowSureADvlSaysItIs) {
  ReplayOptions options;
  options.capture = DRYDOCK_SOURCE_DIR "/fixtures/water-linked/golden.txt";
  options.protocol = "water-linked";
  const auto line = run_replay(options).lines().at(0);
  EXPECT_EQ(line["figure_of_merit_mps"], 0.003);
  const std::vector<double> sigma = line["velocity_sigma_mps"];
  ASSERT_EQ(sigma.size(), 3u);
  EXPECT_NEAR(sigma[0] * sigma[0], 2.5e-6, 1e-12);
  EXPECT_NEAR(sigma[1] * sigma[1], 4e-6, 1e-12);
  EXPECT_NEAR(sigma[2] * sigma[2], 1e-6, 1e-12);
}

/// The capture has no times of its own. A microsecond is the step of a double of these seconds.
TEST(Replay, ADvlWithItsOwnClockIsValidWhenItSaysAndCameWhenItWasSent) {
  const auto water_linked = run_replay_of_dvl("water-linked", wrz).lines();
  ASSERT_EQ(water_linked.size(), 3u);
  const double valid_s[] = {0, 0.2, 0.4}, age_s[] = {0.15, 0.09, 0.2};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(water_linked[i]["valid_at_s"].get<double>() - 1.7e9, valid_s[i], 5e-6);
    EXPECT_NEAR(water_linked[i]["received_at_s"].get<double>() - 1.7e9, valid_s[i] + age_s[i],
                5e-6);
  }
  const auto nortek = run_replay_of_dvl("nortek", pnorbt7).lines();
  ASSERT_EQ(nortek.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(nortek[i]["valid_at_s"].get<double>() - 1.7e9, i + 0.147361, 5e-6);
    EXPECT_NEAR(nortek[i]["received_at_s"].get<double>() - 1.7e9, i + 0.195483, 5e-6);
  }
}

TEST(Replay, AtItsOwnPaceItGivesTheSameMeasurements) {
  const TemporaryFile file(log);
  ReplayOptions options = options_for(file);
  options.speed = "50";
  const Decoded result = run_replay(options);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  ASSERT_EQ(result.lines().size(), 2u);
  EXPECT_NEAR(result.lines()[1]["pressure_pa"].get<double>(), 151177.5, 1e-6);
  EXPECT_THAT(result.err, HasSubstr("end of the recording"));
}

TEST(Replay, WhatCannotBePlayedIsOneLine) {
  const TemporaryFile file(log);
  ReplayOptions options = options_for(file);
  options.kind.clear();
  EXPECT_EQ(
      run_replay(options).err,
      "replay: --kind says which sensor speaks nmea2000; allowed: emlog, gnss, depth, actuator, "
      "attitude\n");
  options.protocol = "morse";
  EXPECT_THAT(run_replay(options).err,
              MatchesRegex("replay: no driver speaks \"morse\"; allowed: ubx, [^\n]*pd0[^\n]*\n"));
  options = options_for(file);
  options.capture = "/nowhere.log";
  EXPECT_EQ(run_replay(options).err,
            "replay: cannot read /nowhere.log: No such file or directory\n");
  const TemporaryFile text("hello\n");
  const Decoded unknown = run_replay(options_for(text));
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_THAT(
      unknown.err,
      HasSubstr("no CAN capture of a known format; known are: pcap, pcapng, blf, candump-log"));
}

/// Good lines of PD6 in another order than that of the maker's guide make no ensemble.
TEST(Replay, WithoutAMeasurementItSaysWhy) {
  std::string lines;
  for (int i = 0; i < 3; ++i)
    lines +=
        ":SA, +1.00, -2.00, 90.00\r\n:TS,26112610100500,35.0,+12.5,  10.0,1500.0,  0\r\n"
        ":BI,  +500,  +100,   -10,    +1,A\r\n:WI,-32768,-32768,-32768,-32768,V\r\n";
  const TemporaryFile file(lines);
  ReplayOptions options;
  options.capture = file.path();
  options.protocol = "pd6";
  const Decoded result = run_replay(options);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("no measurement: an ensemble was left out: a line was lost, "
                                    "damaged or not in the order SA TS WI WS WE WD BI BS BE BD"));
}

/// RFC 1952: 1F 8B, and 8 for deflate.
TEST(Replay, AFileThatIsCompressedIsSaidWhateverItsProtocol) {
  const TemporaryFile file(std::string_view("\x1F\x8B\x08\0\0\0\0\0\2\3", 10));
  ReplayOptions options;
  options.capture = file.path();
  options.protocol = "pd0";
  EXPECT_THAT(run_replay(options).err,
              HasSubstr("it is compressed: unpack it first with gunzip -k"));
  options.protocol = "nmea2000";
  options.kind = "depth";
  options.format = "candump-log";
  EXPECT_THAT(run_replay(options).err,
              HasSubstr("it is compressed: unpack it first with gunzip -k"));
}

}  // namespace replay_test
}  // namespace drydock::decode

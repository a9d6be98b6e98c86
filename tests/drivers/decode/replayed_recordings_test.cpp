#include <fmt/format.h>
#include <gmock/gmock.h>

#include "drivers/decode/replay.hpp"
#include "tests/drivers/decode/captured.hpp"

/// Recordings of several buses, of a clock that was set, and with a torn end.
namespace drydock::decode {
namespace replayed_recordings_test {

using testing::HasSubstr;

/// NMEA 2000 pressure (130314) of source 35.
std::string pressure(double at_s, std::string_view bus, int sequence) {
  return fmt::format("({:.6f}) {} 19FD0A23#{:02X}00015F111700FF\n", at_s, bus, sequence);
}

Decoded replayed(const std::string& log, const std::string& interface = "") {
  const TemporaryFile file(log);
  ReplayOptions options;
  options.capture = file.path();
  options.protocol = "nmea2000";
  options.kind = "depth";
  options.interface = interface;
  MemoryFile out, err;
  Decoded result;
  result.exit_code = replay(options, out.file(), err.file());
  result.out = out.text();
  result.err = err.text();
  return result;
}

TEST(ReplayedRecording, OfSeveralBusesPlaysTheOneThatHoldsTheDevice) {
  const auto result = replayed("(9.000000) can0 123#11\n" + pressure(10, "can1", 0) +
                               "(10.200000) can0 123#22\n" + pressure(10.5, "can1", 1));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  ASSERT_EQ(result.lines().size(), 2u);
  EXPECT_EQ(result.lines()[1]["received_at_s"], 10.5);
  EXPECT_THAT(result.err, HasSubstr("bus can1: no other"));
}

TEST(ReplayedRecording, OfADeviceOnTwoBusesNeedsAChoice) {
  const std::string log = pressure(10, "can0", 0) + pressure(10.1, "can1", 0) +
                          pressure(11, "can0", 1) + pressure(11.1, "can1", 1);
  const auto unchosen = replayed(log);
  EXPECT_EQ(unchosen.exit_code, 1);
  EXPECT_THAT(unchosen.err, HasSubstr("on several buses: can0, can1; --interface chooses one"));
  EXPECT_EQ(replayed(log, "can1").lines().size(), 2u);
}

TEST(ReplayedRecording, WhoseClockWasSetBackGoesOnFromItsLastTime) {
  const auto result = replayed(pressure(5000, "can0", 0) + pressure(5001, "can0", 1) +
                               pressure(1401, "can0", 2) + pressure(1402, "can0", 3));
  ASSERT_EQ(result.lines().size(), 4u);
  EXPECT_EQ(result.lines()[2]["received_at_s"], 5001.0);
  EXPECT_EQ(result.lines()[3]["received_at_s"], 5002.0);
  EXPECT_THAT(result.err, HasSubstr("the recording's clock was set back once, by 3600.000 s"));
}

/// A GGA of that second, without its line end; the checksum is the XOR of what stands before it.
std::string position(int second) {
  const auto text = fmt::format(
      "GNGGA,1000{:02}.00,1000.0000,N,02000.0000,E,4,18,0.7,3.2,M,17.5,M,1.0,0001", second);
  unsigned sum = 0;
  for (const char c : text) sum ^= static_cast<unsigned char>(c);
  return fmt::format("${}*{:02X}", text, sum);
}

TEST(ReplayedRecording, TheLastSentenceWithoutItsLineEndHasTheTimeOfTheDevicesClock) {
  std::string text;
  for (int second = 0; second < 20; ++second)
    text += position(second) + (second < 19 ? "\r\n" : "");
  const TemporaryFile file(text);
  ReplayOptions options;
  options.capture = file.path();
  options.protocol = "nmea0183";
  options.kind = "gnss";
  std::vector<double> times;
  play(options, [&](const measurement::Measurement& m) {
    times.push_back(measurement::seconds(measurement::origin_of(m).received_at.time_since_epoch()));
  });
  ASSERT_EQ(times.size(), 20u);
  EXPECT_NEAR(times.back() - times.front(), 19, 1e-6);
}

TEST(ReplayedRecording, GivesTheLastSentenceWithoutItsLineEnd) {
  for (const std::string end : {"\r\n", "\n", "\r", ""}) {
    const TemporaryFile file("$GPHDT,75.5664,T*36\r\n$GNTHS,244.17,A*1D" + end);
    ReplayOptions options;
    options.capture = file.path();
    options.protocol = "nmea0183";
    options.kind = "attitude";
    MemoryFile out, err;
    EXPECT_EQ(replay(options, out.file(), err.file()), 0);
    EXPECT_THAT(err.text(), HasSubstr("2 measurements, 2 frames, 0 bad checksums, 0 bytes"));
  }
}

}  // namespace replayed_recordings_test
}  // namespace drydock::decode

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "hil/diagnose/sources.hpp"

/// A diagnosis of captures of buses.
namespace drydock::diagnose {
namespace capture_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Outcome diagnosed(const std::string& log) {
  const auto path =
      std::filesystem::temp_directory_path() / fmt::format("drydock-diagnosed-{}.log", ::getpid());
  std::ofstream(path) << log;
  auto outcome = read_capture(path.string(), 0);
  std::filesystem::remove(path);
  return outcome;
}

std::string frame(double at_s, std::string_view bus, std::string_view frame) {
  return fmt::format("({:.6f}) {} {}\n", 1'700'000'000 + at_s, bus, frame);
}

/// A CiA 404 pressure sensor of node 10 for 30 s: 10 Hz, and a heartbeat each second until then.
/// `more(i)`: what comes behind sample i.
template <class More>
std::string pressure(const More& more, double last_heartbeat_s = 30) {
  std::string log;
  for (int i = 0; i < 300; ++i) {
    const double at_s = 0.1 * i;
    const int pascal = 101'325 + 100 * i;
    log += frame(at_s, "can0",
                 fmt::format("18A#{:02X}{:02X}{:02X}{:02X}00", pascal & 0xFF, pascal >> 8 & 0xFF,
                             pascal >> 16 & 0xFF, 0));
    if (i % 10 == 0 && at_s <= last_heartbeat_s) log += frame(at_s + 0.002, "can0", "70A#05");
    log += more(i);
  }
  return log;
}

constexpr auto nothing = [](int) { return std::string(); };

TEST(DiagnosedCapture, OfASoundNodeHasNoFinding) {
  EXPECT_THAT(diagnosed(pressure(nothing)).findings, IsEmpty());
}

// CiA 301: code 8110h, CAN overrun.
TEST(DiagnosedCapture, OfANodeWithAnEmergencyHasItsError) {
  const auto outcome = diagnosed(pressure([](int i) {
    return i == 100 ? frame(10.003, "can0", "08A#1081110102030405") : std::string();
  }));
  ASSERT_EQ(outcome.findings.size(), 1u);
  EXPECT_EQ(outcome.findings[0].cause, "device-error");
  EXPECT_NEAR(outcome.findings[0].since_s, 10, 0.5);
  EXPECT_THAT(to_text(outcome), HasSubstr("its driver says: node 10: emergency 0x8110"));
}

TEST(DiagnosedCapture, OfANodeWithoutItsHeartbeatHasItsLoss) {
  const auto outcome = diagnosed(pressure(nothing, 10));
  ASSERT_EQ(outcome.findings.size(), 1u);
  EXPECT_EQ(outcome.findings[0].cause, "device-error");
  EXPECT_NEAR(outcome.findings[0].since_s, 13, 0.5);  // 3 s later: DriverOptions
  EXPECT_THAT(to_text(outcome), HasSubstr("lost: no heartbeat"));
}

/// NMEA 2000 pressure (130314) of source 35 at 10 Hz, from `begin_s` for a minute.
std::string nmea2000(double begin_s, const std::vector<std::string_view>& buses) {
  std::string log;
  for (int i = 0; i < 600; ++i)
    for (const auto bus : buses)
      log +=
          frame(begin_s + 0.1 * i, bus,
                fmt::format("19FD0A23#{:02X}0001{:02X}11170{}FF", i % 250, 0x40 + i * 37 % 32, 0));
  return log;
}

TEST(DiagnosedCapture, OfTwoBusesHasNoMessageTwice) {
  const auto outcome = diagnosed(nmea2000(0, {"can0", "can1"}));
  EXPECT_EQ(outcome.devices.size(), 2u);
  EXPECT_THAT(outcome.findings, IsEmpty());
}

TEST(DiagnosedCapture, SaysHowLongASilenceWas) {
  const auto outcome = diagnosed(nmea2000(0, {"can0"}) + nmea2000(660, {"can0"}));
  ASSERT_EQ(outcome.findings.size(), 1u);
  EXPECT_EQ(outcome.findings[0].cause, "silent");
  ASSERT_FALSE(outcome.findings[0].evidence.empty());
  EXPECT_NEAR(outcome.findings[0].evidence[0].value, 600, 1);
}

TEST(DiagnosedCapture, WhoseClockWasSetBackIsReadToItsEnd) {
  const auto outcome = diagnosed(nmea2000(0, {"can0"}) + nmea2000(-3600, {"can0"}));
  EXPECT_NEAR(outcome.circumstances.duration_s, 119.8, 0.5);
  EXPECT_THAT(outcome.notes, ElementsAre(HasSubstr("the recording's clock was set back once")));
}

}  // namespace capture_test
}  // namespace drydock::diagnose

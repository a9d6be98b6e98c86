#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "drivers/probe/probe_report.hpp"

/// What a probe says of recordings.
namespace drydock::probe {
namespace probe_recording_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A file that is gone with the test.
struct Recorded {
  explicit Recorded(const std::string& content) {
    std::ofstream(path, std::ios::binary) << content;
    report = find_sensors("file:" + path.string() + "?speed=max", 0);
  }
  ~Recorded() { std::filesystem::remove(path); }
  std::filesystem::path path =
      std::filesystem::temp_directory_path() /
      fmt::format("drydock-probed-{}", ::testing::UnitTest::GetInstance()->random_seed());
  ProbeReport report;
};

/// NMEA 2000 pressure (130314) of source 35, at 10 Hz for 10 s, at so many seconds since 1970.
std::string pressure_at(double begin_s, std::string_view bus) {
  std::string log;
  for (int i = 0; i < 100; ++i)
    log += fmt::format("({:.6f}) {} 19FD0A23#{:02X}00015F111700FF\n", begin_s + 0.1 * i, bus, i);
  return log;
}

/// The lines of two logs in turn.
std::string in_turn(const std::string& one, const std::string& other) {
  std::string log;
  std::size_t a = 0, b = 0;
  while (a < one.size()) {
    const auto next_a = one.find('\n', a) + 1, next_b = other.find('\n', b) + 1;
    log += one.substr(a, next_a - a) + other.substr(b, next_b - b);
    a = next_a;
    b = next_b;
  }
  return log;
}

std::vector<std::string> links_of(const ProbeReport& report) {
  std::vector<std::string> links;
  for (const auto& device : report.devices) links.push_back(device.link);
  return links;
}

TEST(ProbedRecording, OfTwoBusesHasEachWithItsOwnDevicesAndRates) {
  const Recorded file(in_turn(pressure_at(1000, "can0"), pressure_at(1000.01, "can1")));
  ASSERT_EQ(file.report.buses.size(), 2u);
  EXPECT_EQ(file.report.buses[0].frames, 100u);
  EXPECT_EQ(file.report.frames, 200u);
  EXPECT_THAT(links_of(file.report),
              ElementsAre(HasSubstr("interface=can0"), HasSubstr("interface=can1")));
  for (const auto& device : file.report.devices) EXPECT_NEAR(device.rate_hz.value(), 10, 0.1);
  for (const auto& node : file.report.nodes)
    EXPECT_NEAR(node.traffic.at(0).rate_hz.value(), 10, 0.1) << node.bus;
}

TEST(ProbedRecording, OfOneBusNeedsNoInterfaceInItsLink) {
  const Recorded file(pressure_at(1000, "can0"));
  EXPECT_TRUE(file.report.buses.empty());
  EXPECT_THAT(links_of(file.report), ElementsAre(Not(HasSubstr("interface="))));
}

TEST(ProbedRecording, WhoseClockWasSetBackGoesOn) {
  const Recorded file(pressure_at(10'000, "can0") + pressure_at(6'400, "can0"));
  EXPECT_NEAR(file.report.listened_s, 19.8, 1e-6);
  EXPECT_THAT(file.report.recording,
              ElementsAre(HasSubstr("the recording's clock was set back once, by 3609.900 s")));
  EXPECT_NEAR(file.report.devices.at(0).rate_hz.value(), 10, 0.1);
}

constexpr std::string_view hdt = "$GPHDT,75.5664,T*36", ths = "$GNTHS,244.17,A*1D";  // of manuals

TEST(ProbedRecording, GivesTheLastSentenceWithoutItsLineEnd) {
  const std::string text = std::string(hdt) + "\r\n" + std::string(ths);
  const Recorded file(text);
  const auto& best = file.report.attempts.at(0).findings.at(0);
  EXPECT_EQ(best.proofs, 2u);
  EXPECT_EQ(best.bytes, text.size());
  EXPECT_EQ(best.bytes_good, text.size());
}

TEST(ProbedRecording, GivesTheLastSentenceWhereCarriageReturnsEndLines) {
  const Recorded file(std::string(hdt) + "\r" + std::string(ths) + "\r");
  EXPECT_EQ(file.report.attempts.at(0).findings.at(0).proofs, 2u);
}

TEST(ProbedRecording, OfSentencesWithoutChecksumsSaysSo) {
  std::string text;
  for (int i = 0; i < 20; ++i) text += fmt::format("$GPHDT,{}.5664,T\r\n", i);
  const Recorded file(text);
  EXPECT_THAT(file.report.notes, Contains(HasSubstr("NMEA 0183 without checksums")));
}

TEST(ProbedRecording, OfAnythingElseGetsNoAdviceAboutWires) {
  for (const std::string text :
       {"", "Time,Channel,ID\n0.0,1,418316033\n", "\x01\x02\x03\xFF", "MDF     4.10    "}) {
    const Recorded file(text);
    EXPECT_THAT(file.report.notes, Not(testing::IsEmpty())) << text;
    for (const auto& note : file.report.notes) {
      EXPECT_THAT(note, Not(HasSubstr("RS-422"))) << text;
      EXPECT_THAT(note, Not(HasSubstr("power"))) << text;
    }
  }
  EXPECT_THAT(Recorded("").report.notes, ElementsAre("the file is empty"));
  EXPECT_THAT(Recorded("MDF     4.10    ").report.notes, ElementsAre(HasSubstr("MF4")));
}

}  // namespace probe_recording_test
}  // namespace drydock::probe

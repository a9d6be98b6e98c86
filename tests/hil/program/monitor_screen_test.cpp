// The monitor on terminals of several kinds and sizes; tmux reads what it draws.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/hil/program/running.hpp"
#include "tests/hil/program/terminal_screen.hpp"

namespace monitor_screen_test {

using program::Folder;
using program::Running;
using program::TerminalScreen;
using testing::HasSubstr;
using testing::Not;

constexpr auto demo = "rig_config/rigs/demo.toml";

std::string line_of(const std::string& text, std::size_t number) {
  std::istringstream lines(text);
  std::string line;
  for (std::size_t i = 0; i <= number; ++i) std::getline(lines, line);
  return line;
}

class OnATerminal : public testing::Test {
 protected:
  Folder folder_;
  Running sensors_{folder_, std::string("emulate ") + demo + " --for 60s", "sensors"};
  void SetUp() override { sensors_.line_from("depth: nmea2000"); }
};

struct Size {
  const char* term;
  int width, height;
};

class EverySize : public OnATerminal, public testing::WithParamInterface<Size> {};

TEST_P(EverySize, HasAllDevicesAboveTheValuesOfTheChosenOneAndTheKeysBelow) {
  const auto [term, width, height] = GetParam();
  const TerminalScreen screen(folder_, std::string("monitor ") + demo, term, width, height);
  const auto text = screen.showing("velocity");
  EXPECT_THAT(line_of(text, 0), HasSubstr("demo"));
  EXPECT_THAT(line_of(text, 1), HasSubstr("device       state"));
  const char* names[] = {"dvl", "emlog", "gnss", "imu", "depth", "actuators"};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(line_of(text, 2 + i).find(names[i]), 2U) << text;
  EXPECT_THAT(line_of(text, 8), HasSubstr("dvl: values"));
  EXPECT_THAT(line_of(text, static_cast<std::size_t>(height) - 1), HasSubstr("q quit"));
}

INSTANTIATE_TEST_SUITE_P(Terminals, EverySize,
                         testing::Values(Size{"xterm", 60, 20}, Size{"linux", 80, 24},
                                         Size{"xterm-256color", 200, 50}));

TEST_F(OnATerminal, ArrowsAndLettersChooseWhatIsShownAndQEndsIt) {
  const TerminalScreen screen(folder_, std::string("monitor ") + demo + " --units kn", "xterm", 80,
                              24);
  EXPECT_THAT(screen.showing("velocity"), HasSubstr(" kn"));
  screen.press("Down");
  EXPECT_THAT(screen.showing("distance"), HasSubstr("> emlog"));
  screen.press("Down r");
  EXPECT_THAT(screen.showing("B5 62"), HasSubstr("gnss: raw"));
  screen.press("p");
  EXPECT_THAT(screen.showing("now"), HasSubstr("gnss: plot"));
  screen.press("v / l o n g");
  EXPECT_THAT(screen.showing("filter /long"), Not(HasSubstr("latitude")));
  screen.press("Enter q");
  EXPECT_THAT(screen.showing("exit="), HasSubstr("exit=1"));  // the IMU waits for its start
}

TEST_F(OnATerminal, AWindowThatGrowsIsFilledAtOnce) {
  const TerminalScreen screen(folder_, std::string("monitor ") + demo, "xterm", 60, 20);
  screen.showing("velocity");
  screen.resize(140, 40);
  EXPECT_THAT(line_of(screen.showing("messages"), 39), HasSubstr("q quit"));
}

TEST_F(OnATerminal, ADumbTerminalGetsPlainLines) {
  const TerminalScreen screen(folder_, std::string("monitor ") + demo + " --for 7s", "dumb", 120,
                              50);
  EXPECT_THAT(screen.showing("exit="), HasSubstr("velocity"));
  EXPECT_THAT(screen.bytes(), Not(HasSubstr("\033")));
}

TEST_F(OnATerminal, ABusIsListedByIdentifierInHex) {
  const TerminalScreen screen(folder_,
                              "monitor \"can:auto?name=drydock0&bitrate=250000\" --protocol can",
                              "xterm", 100, 30);
  EXPECT_THAT(screen.showing("701"), HasSubstr("kinds of frames"));
}

TEST_F(OnATerminal, CtrlCEndsItAndTheTerminalIsAsBefore) {
  const TerminalScreen screen(folder_, std::string("monitor ") + demo, "xterm", 80, 24);
  screen.showing("velocity");
  screen.press("C-c");
  EXPECT_THAT(screen.showing("exit="), Not(HasSubstr("q quit")));
}

TEST_F(OnATerminal, ANodeThatWaitsSaysWhoStartsItAndStartStartsIt) {
  const TerminalScreen listening(folder_, std::string("monitor ") + demo, "xterm", 200, 30);
  EXPECT_THAT(listening.showing("pre-operational"), HasSubstr("monitor --start"));
  listening.press("q");
  listening.showing("exit=");
}

TEST_F(OnATerminal, ARecordingShowsTimeSizeAndRatesOnOneLine) {
  const TerminalScreen screen(
      folder_,
      std::string("record ") + demo + " -o " + (folder_ / "dive.mcap").string() + " --for 9s",
      "xterm", 160, 30);
  EXPECT_THAT(screen.showing("MB  dvl 5.0"), HasSubstr("s of 9 s, "));
  EXPECT_THAT(screen.showing("exit="), Not(HasSubstr("s left")));
}

TEST_F(OnATerminal, ANarrowOneShowsTheRatesOfAllDevicesOnFurtherLines) {
  const TerminalScreen screen(
      folder_,
      std::string("record ") + demo + " -o " + (folder_ / "dive.mcap").string() + " --for 9s",
      "xterm", 60, 30);
  const auto text = screen.showing("actuators 10.");
  for (const char* name : {"dvl", "emlog", "gnss", "imu", "depth", "actuators"})
    EXPECT_THAT(text, testing::ContainsRegex(std::string(name) + " [0-9.]+ Hz"));
  const auto after = screen.showing("exit=");
  EXPECT_THAT(after, Not(HasSubstr("s left")));
  EXPECT_THAT(after, Not(HasSubstr("\n  actuators")));  // all lines are wiped
}

TEST(Replay, AtItsOwnSpeedShowsWhatIsGoneWhatIsLeftAndTheRates) {
  const Folder folder;
  const TerminalScreen screen(
      folder, "replay fixtures/dives/dvl-finds-the-bottom/dive.mcap --speed 1 --quiet", "xterm", 79,
      24);
  const auto text = screen.showing("Hz");
  EXPECT_THAT(text, HasSubstr("replay ["));
  EXPECT_THAT(text, HasSubstr("s left"));
  screen.press("C-c");
  EXPECT_THAT(screen.showing("exit="), Not(HasSubstr("s left")));
}

TEST(Record, OfEmulatedDevicesWithoutAnEmulatorSaysWhatMakesThem) {
  const Folder folder;
  const auto outcome = program::drydock(std::string("record ") + demo + " -o " +
                                        (folder / "dive.mcap").string() + " --for 4s");
  EXPECT_THAT(outcome.output, HasSubstr("nothing is there"));
  EXPECT_THAT(outcome.output, HasSubstr("`drydock emulate` makes them"));
}

TEST(Record, ShorterThanTheFirstLookSaysItToo) {
  const Folder folder;
  const auto outcome = program::drydock(std::string("record ") + demo + " -o " +
                                        (folder / "dive.mcap").string() + " --for 1s");
  EXPECT_THAT(outcome.output, HasSubstr("nothing is there"));
}

TEST_F(OnATerminal, BytesThatNoDriverUnderstandsAreSomebody) {
  const auto rig = (folder_ / "wrong.toml").string();
  std::ofstream(rig) << "[rig]\nname = \"wrong\"\n[[device]]\nname = \"dvl\"\nkind = \"dvl\"\n"
                        "protocol = \"pd4\"\nlink = \"pty:dvl?baud=115200\"\nrate_hz = 5\n";
  const Running record(
      folder_, "record " + rig + " -o " + (folder_ / "dive.mcap").string() + " --for 5s", "record");
  EXPECT_TRUE(record.says("recording "));
  EXPECT_THAT(record.output(), Not(HasSubstr("nothing is there")));
}

}  // namespace monitor_screen_test

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string_view>

#include "drivers/monitor/hints/wire_hints.hpp"
#include "drivers/monitor/problems.hpp"

namespace hints_test {

using namespace drydock;
using monitor::bus_hint;
using monitor::line_hint;
using monitor::problems_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

wire::CanFrame frame_of(std::uint32_t id, bool extended, std::initializer_list<std::uint8_t> data) {
  wire::CanFrame frame;
  frame.id = id;
  frame.extended = extended;
  frame.size = static_cast<std::uint8_t>(data.size());
  std::ranges::copy(data, frame.data.begin());
  return frame;
}

survey::ByteSurvey heard(std::string_view text, int times) {
  survey::ByteSurvey survey;
  for (int i = 0; i < times; ++i)
    survey.feed({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
                measurement::Stamp{measurement::from_seconds(i)});
  return survey;
}

device::DriverOptions node(std::string protocol, std::uint8_t address) {
  device::DriverOptions options;
  options.protocol = std::move(protocol);
  options.address = address;
  return options;
}

// The XOR of the characters between $ and * is 62h (NMEA 0183: DPT is depth below the transducer).
constexpr std::string_view depth_sentence = "$SDDPT,12.3,0.5*62\r\n";

TEST(Hints, AnotherProtocolIsNamed) {
  EXPECT_EQ(line_hint(heard(depth_sentence, 50), "pd4"),
            "bytes, but no pd4 frame; they look like nmea0183");
}

TEST(Hints, SentencesThatNobodyUsesAreNamed) {
  EXPECT_THAT(line_hint(heard(depth_sentence, 50), "nmea0183"), HasSubstr("heard and not used: "));
  EXPECT_THAT(line_hint(heard(depth_sentence, 50), "nmea0183"), HasSubstr("DPT"));
}

TEST(Hints, BytesOfNoProtocolMayHaveAnotherBaudRate) {
  EXPECT_EQ(line_hint(heard("\x80\x78\x80", 10), "ubx"),
            "30 bytes, but no ubx frame, nor one of any other protocol: the baud rate?");
}

/// At a wrong rate hardly a byte is text.
TEST(Hints, TextOfNoProtocolIsAConsole) {
  EXPECT_EQ(line_hint(heard("\r\n> ", 3), "nmea0183"),
            "text without a nmea0183 frame: \"> > > \"; does it wait for a command?");
}

TEST(Hints, SilenceNeedsNoHint) { EXPECT_EQ(line_hint(heard("", 0), "ubx"), ""); }

// CiA 301: COB-ID 700h + node, state 7Fh is pre-operational, 05h operational.
TEST(Hints, ANodeThatWaitsForItsStartSaysWhoStartsIt) {
  survey::BusSurvey bus;
  bus.receive(frame_of(0x701, false, {0x7F}), {});
  EXPECT_EQ(bus_hint(bus.nodes(), node("cia404-imu", 1)),
            "node 1 is pre-operational: nobody started it; drydock drive does, or monitor --start");
}

// PGN 126992 from source 35: identifier 0DF01023h.
TEST(Hints, AWrongAddressIsToldTheAddressesThatAreThere) {
  survey::BusSurvey bus;
  bus.receive(frame_of(0x701, false, {0x05}), {});
  bus.receive(frame_of(0x0DF01023, true, {0, 0, 0, 0, 0, 0, 0, 0}), {});
  bus.receive(frame_of(0x0DF01024, true, {0, 0, 0, 0, 0, 0, 0, 0}), {});
  EXPECT_EQ(bus_hint(bus.nodes(), node("cia404-imu", 2)),
            "nothing from address 2; heard: CANopen node 1; N2K sources 35, 36");
}

TEST(Hints, ANodeThatRunsNeedsNoHint) {
  survey::BusSurvey bus;
  bus.receive(frame_of(0x701, false, {0x05}), {});
  EXPECT_EQ(bus_hint(bus.nodes(), node("cia404-imu", 1)), "");
}

monitor::DeviceView good() {
  monitor::DeviceView view;
  view.streaming = true;
  view.state = "streaming";
  view.rate_hz = view.nominal_rate_hz = 5;
  view.frames = 100;
  return view;
}

TEST(Problems, AGoodDeviceHasNone) { EXPECT_THAT(problems_of(good()), IsEmpty()); }

TEST(Problems, OneHertzOfFiveIsOne) {
  auto view = good();
  view.rate_hz = 1;
  EXPECT_THAT(problems_of(view), ElementsAre("1.00 Hz of 5.0 Hz"));
}

TEST(Problems, EightDamagedFramesOfThirteenAreOne) {
  auto view = good();
  view.frames = 5;
  view.bad_checksums = 8;
  EXPECT_THAT(problems_of(view), ElementsAre("8 of 13 frames damaged"));
}

TEST(Problems, AFrameInAHundredIsStillNone) {
  auto view = good();
  view.frames = 99;
  view.bad_checksums = 1;
  EXPECT_THAT(problems_of(view), IsEmpty());
}

/// Who begins to listen between the frames of one sample has lost that sample, and nothing else.
TEST(Problems, TheFrameInWhichListeningBeganIsNone) {
  auto view = good();
  view.frames = 6;
  view.bad_checksums = 1;
  EXPECT_THAT(problems_of(view), IsEmpty());
  view.bad_checksums = 2;
  EXPECT_THAT(problems_of(view), ElementsAre("2 of 8 frames damaged"));
}

TEST(Problems, APortThatAnotherProgramReadsIsOne) {
  auto view = good();
  view.shared_with = "drydock (process 7)";
  EXPECT_THAT(problems_of(view),
              ElementsAre("each reads a part of the bytes: also open in drydock (process 7)"));
}

TEST(Problems, NoDeviceAtAllIsNotWell) {
  EXPECT_FALSE(monitor::all_well({}));
  EXPECT_TRUE(monitor::all_well({good()}));
}

}  // namespace hints_test

// The screens are compared as a whole with the files of this folder: what a person sees.
#include "drivers/monitor/screen/screen.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "drivers/monitor/screen/keys.hpp"

namespace screen_test {

using namespace drydock::monitor;

/// 2001-09-09 01:46:40 UTC.
constexpr double now_s = 1e9;

DeviceView device_of(std::string name, std::string kind, std::string protocol, bool streaming) {
  DeviceView view;
  view.name = std::move(name);
  view.kind = std::move(kind);
  view.protocol = std::move(protocol);
  view.link = "pty:" + view.name;
  view.streaming = streaming;
  view.state = streaming ? "streaming" : "waiting";
  view.status = streaming ? "streaming" : "no message for 11 s on a bus that is up";
  view.rate_hz = streaming ? 5 : 0;
  view.nominal_rate_hz = 5;
  if (streaming) view.age_s = 0.125;
  view.jitter_s = 0.002;
  return view;
}

ScreenState rig_of_three() {
  ScreenState state;
  state.title = "demo";
  state.now_s = now_s;
  state.devices = {device_of("dvl", "dvl", "pd0", true), device_of("gnss", "gnss", "ubx", true),
                   device_of("imu", "imu", "cia404-imu", false)};
  state.devices[0].values = {{"velocity", "1.500 -0.250 0.010", "m/s", {1.5, -0.25, 0.01}},
                             {"altitude", "59.650", "m", {59.65}}};
  state.devices[0].received_at_s = now_s - 0.125;
  state.devices[0].valid_at_s = now_s - 0.25;
  state.devices[0].latency_s = 0.125;
  state.devices[1].values = {{"latitude", "36.0000000", "deg", {36}},
                             {"longitude", "-139.1234567", "deg", {-139.1234567}},
                             {"temperature", "12.500", "°C", {12.5}}};
  return state;
}

std::string text_of(const Canvas& canvas) {
  std::string all;
  for (std::size_t row = 0; row < canvas.height(); ++row) all += canvas.text(row) + '\n';
  return all;
}

std::string expected(const std::string& file) {
  std::ifstream in(DRYDOCK_SOURCE_DIR "/tests/drivers/monitor/screens/" + file + ".txt");
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

TEST(Screen, TheValuesOfTheFirstDeviceOnSixtyByTwenty) {
  EXPECT_EQ(text_of(draw_screen(rig_of_three(), 60, 20)), expected("values-60x20"));
}

TEST(Screen, ASilentDeviceSaysWhyOnEightyByTwentyFour) {
  auto state = rig_of_three();
  press(state, Key::up);
  EXPECT_EQ(text_of(draw_screen(state, 80, 24)), expected("silent-80x24"));
}

TEST(Screen, APositionOnTwoHundredByFifty) {
  auto state = rig_of_three();
  press(state, Key::down);
  EXPECT_EQ(text_of(draw_screen(state, 200, 50)), expected("position-200x50"));
}

TEST(Screen, ChangedBytesAreMarkedAndTheFrameHasItsFieldsBeside) {
  auto state = rig_of_three();
  state.wire.frames = {{"701", 12, 1, {0x7F}, {false}, {{"state", "pre_operational", ""}}},
                       {"1A0", 99, 9.5, {1, 2, 0xFF}, {false, true, false}, {}}};
  press(state, Key::character, 'r');
  const auto canvas = draw_screen(state, 80, 24);
  EXPECT_EQ(text_of(canvas), expected("raw-80x24"));
  EXPECT_EQ(canvas.marks(8, Style::changed), std::string(42, ' ') + "^^");
}

TEST(Screen, AValueThatRisesEvenlyIsAStraightLineFromTheLeftToTheRight) {
  auto state = rig_of_three();
  History history;
  for (int i = 0; i <= 60; ++i) history.add("dvl", "altitude", {now_s - 60 + i, {100.0 + i}});
  state.history = &history;
  press(state, Key::right);
  press(state, Key::character, 'p');
  EXPECT_EQ(text_of(draw_screen(state, 80, 24)), expected("plot-80x24"));
}

TEST(Screen, TheFilterHidesOtherValues) {
  auto state = rig_of_three();
  press(state, Key::down);
  for (const char c : std::string("/lat")) press(state, Key::character, c);
  const auto text = text_of(draw_screen(state, 80, 24));
  EXPECT_NE(text.find("filter /lat_"), std::string::npos);
  EXPECT_NE(text.find("latitude"), std::string::npos);
  EXPECT_EQ(text.find("longitude"), std::string::npos);
  press(state, Key::escape);
  EXPECT_NE(text_of(draw_screen(state, 80, 24)).find("longitude"), std::string::npos);
}

TEST(Screen, HeadsAndTheChosenDeviceStayThoughThereAreMoreDevicesThanRows) {
  auto state = rig_of_three();
  for (int i = 0; i < 37; ++i)
    state.devices.push_back(device_of("extra" + std::to_string(i), "depth", "nmea2000", true));
  state.choice.device = 39;
  const auto text = text_of(draw_screen(state, 60, 20));
  EXPECT_NE(text.find("  device"), std::string::npos);
  EXPECT_NE(text.find("> extra36"), std::string::npos);
  EXPECT_NE(text.find("28 devices more"), std::string::npos);
}

TEST(Screen, NoSizeIsTooSmallToDraw) {
  for (std::size_t height = 0; height < 30; ++height)
    for (const std::size_t width : {0U, 1U, 7U, 59U, 60U, 61U, 132U}) {
      for (const Pane pane : {Pane::values, Pane::plot, Pane::raw}) {
        auto state = rig_of_three();
        state.choice.pane = pane;
        const auto canvas = draw_screen(state, width, height);
        EXPECT_EQ(canvas.height(), height);
      }
    }
}

TEST(Screen, TheStateOfASilentDeviceIsInAnotherColourThanThatOfAGoodOne) {
  const auto canvas = draw_screen(rig_of_three(), 80, 24);
  EXPECT_EQ(canvas.at(2, 15).style, Style::good);
  EXPECT_EQ(canvas.at(4, 15).style, Style::wrong);
}

TEST(Screen, AControlCharacterOfADeviceDoesNotReachTheTerminal) {
  auto state = rig_of_three();
  state.devices[0].last_error = "evil \033[2J text";
  const auto text = text_of(draw_screen(state, 80, 24));
  EXPECT_EQ(text.find('\033'), std::string::npos);
  EXPECT_NE(text.find("evil ?[2J text"), std::string::npos);
}

}  // namespace screen_test

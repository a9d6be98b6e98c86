#include "drivers/monitor/frames/wire_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

namespace wire_watch_test {

using namespace drydock;
using monitor::ShownFrame;
using monitor::ShownWire;

measurement::Stamp at(double s) { return measurement::Stamp{measurement::from_seconds(s)}; }

wire::CanFrame frame_of(std::uint32_t id, bool extended, std::initializer_list<std::uint8_t> data) {
  wire::CanFrame frame;
  frame.id = id;
  frame.extended = extended;
  frame.size = static_cast<std::uint8_t>(data.size());
  std::ranges::copy(data, frame.data.begin());
  return frame;
}

std::string field_of(const ShownFrame& frame, const std::string& name) {
  for (const auto& field : frame.fields)
    if (field.name == name) return field.text;
  return "none";
}

wire::Bytes bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(WireWatch, IdentifiersAreHexOfElevenAndTwentyNineBits) {
  const auto bus = monitor::watch_bus();
  bus->receive(frame_of(0x1A0, false, {1}), at(0));
  bus->receive(frame_of(0x9F10D24, true, {2}), at(0));
  const auto wire = bus->show();
  ASSERT_EQ(wire.frames.size(), 2U);
  EXPECT_EQ(wire.frames[0].name, "1A0");
  EXPECT_EQ(wire.frames[1].name, "09F10D24");
}

TEST(WireWatch, OnlyTheBytesThatChangedSinceTheLastLookAreMarked) {
  const auto bus = monitor::watch_bus();
  bus->receive(frame_of(0x1A0, false, {1, 2, 3}), at(0));
  const std::vector<bool> none(3, false), second{false, true, false};
  EXPECT_EQ(bus->show().frames[0].changed, none);
  bus->receive(frame_of(0x1A0, false, {1, 9, 3}), at(0.1));
  EXPECT_EQ(bus->show().frames[0].changed, second);
  EXPECT_EQ(bus->show().frames[0].changed, none);
}

TEST(WireWatch, TenFramesASecondAreTenHertz) {
  const auto bus = monitor::watch_bus();
  for (int i = 0; i < 20; ++i) bus->receive(frame_of(1, false, {}), at(0.1 * i));
  EXPECT_NEAR(bus->show().frames[0].rate_hz, 10, 1e-6);
  EXPECT_EQ(bus->show().frames[0].count, 20U);
}

// CiA 301, 7.2.8.3.2.2: a heartbeat is COB-ID 700h + node, and 7Fh is pre-operational.
TEST(WireWatch, TheProtocolOfADeviceNamesTheFieldsOfItsFrames) {
  const auto bus = monitor::watch_bus();
  bus->add("cia404-imu", nullptr);
  bus->receive(frame_of(0x701, false, {0x7F}), at(0));
  const auto wire = bus->show();
  EXPECT_EQ(field_of(wire.frames[0], "type"), "heartbeat");
  EXPECT_EQ(field_of(wire.frames[0], "node"), "1");
  EXPECT_EQ(field_of(wire.frames[0], "state"), "pre_operational");
}

TEST(WireWatch, AnEndlessNumberOfIdentifiersIsCountedNotKept) {
  const auto bus = monitor::watch_bus();
  for (std::uint32_t id = 0; id < 1000; ++id) bus->receive(frame_of(id, true, {}), at(0));
  const auto wire = bus->show();
  EXPECT_EQ(wire.frames.size(), monitor::WireWatch::most_kinds);
  EXPECT_EQ(wire.not_listed, 1000 - monitor::WireWatch::most_kinds);
}

// The sentence of the NMEA 0183 standard's GLL example form; XOR of its characters is 31h.
TEST(WireWatch, ASentenceIsShownAsItsBytesBesideItsFields) {
  const auto line = monitor::watch_bytes("nmea0183", nullptr);
  ASSERT_TRUE(line);
  const std::string_view sentence = "$GPGLL,4916.45,N,12311.12,W,225444,A*31\r\n";
  line->receive(bytes_of(sentence), at(0));
  const auto wire = line->show();
  ASSERT_EQ(wire.frames.size(), 1U);
  EXPECT_EQ(wire.frames[0].bytes.size(), sentence.size());
  EXPECT_FALSE(wire.frames[0].fields.empty());
}

/// Ensembles at 5 Hz; a bit of the third one's length says 4096 bytes more.
TEST(WireWatch, EnsemblesBehindADamagedLengthAreShownWithTheirOwnTimes) {
  std::ifstream file(DRYDOCK_SOURCE_DIR "/fixtures/pd0/golden.pd0", std::ios::binary);
  std::vector<std::uint8_t> ensemble{std::istreambuf_iterator<char>(file), {}};
  ensemble.resize((ensemble.at(2) | ensemble.at(3) << 8) + 2U);
  const auto line = monitor::watch_bytes("pd0", nullptr);
  for (int i = 0; i < 12; ++i) {
    auto sent = ensemble;
    if (i == 2) sent[3] = static_cast<std::uint8_t>(sent[3] ^ 1U << 4);
    line->receive(sent, at(0.2 * i));
  }
  const auto wire = line->show();
  ASSERT_EQ(wire.frames.size(), 1U);
  EXPECT_EQ(wire.frames[0].count, 11U);
  EXPECT_NEAR(wire.frames[0].rate_hz, 10 / 2.2, 1e-6);  // ten intervals in 2.2 s
}

TEST(WireWatch, ACanProtocolIsNoneOfAByteLink) {
  EXPECT_EQ(monitor::watch_bytes("cia404-imu", nullptr), nullptr);
}

}  // namespace wire_watch_test

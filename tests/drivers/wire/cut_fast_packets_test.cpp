#include <gtest/gtest.h>

#include "drivers/wire/nmea2000/nmea2000.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// Messages of several frames of which some did not come.
namespace drydock::wire {
namespace cut_fast_packets_test {

constexpr j1939::Identifier position{3, 129029, 255, 7};

std::vector<CanFrame> frames_for(const j1939::Identifier& id, std::uint8_t sequence,
                                 const std::vector<std::uint8_t>& message) {
  std::vector<CanFrame> frames;
  for (std::size_t i = 0; i < fast_packet_frames(message.size()); ++i)
    frames.push_back(encode_fast_packet(id, sequence, message, i));
  return frames;
}

void hear(FastPacketAssembler& assembler, const CanFrame& frame,
          std::chrono::nanoseconds now = {}) {
  assembler.receive(j1939::parse_identifier(frame.id), frame.payload(), now);
}

TEST(CutFastPackets, AMessageWithoutItsFirstFrameIsCountedOnce) {
  FastPacketAssembler assembler;
  const std::vector<std::uint8_t> message(43, 0x11);
  for (const std::uint8_t sequence : {0, 1, 2}) {
    const auto frames = frames_for(position, sequence, message);
    for (std::size_t i = sequence == 1 ? 1 : 0; i < frames.size(); ++i) hear(assembler, frames[i]);
  }
  EXPECT_EQ(assembler.counters().messages, 2u);
  EXPECT_EQ(assembler.counters().headless, 1u);
  EXPECT_EQ(assembler.counters().dropped, 0u);
  EXPECT_EQ(assembler.unfinished(), 0u);
}

TEST(CutFastPackets, TheRestOfALostMessageAndADuplicateAreNoOtherMessage) {
  FastPacketAssembler assembler;
  const std::vector<std::uint8_t> message(43, 0x11);
  auto frames = frames_for(position, 0, message);
  const CanFrame last = frames.back();
  for (const auto& frame : frames) hear(assembler, frame);
  hear(assembler, last);
  frames = frames_for(position, 1, message);
  frames.erase(frames.begin() + 2);
  for (const auto& frame : frames) hear(assembler, frame);
  EXPECT_EQ(assembler.counters().dropped, 1u);
  EXPECT_EQ(assembler.counters().headless, 0u);
}

TEST(CutFastPackets, AFrameThatComesMoreThan750MsAfterTheOneBeforeIsOfAnotherMessage) {
  using namespace std::chrono_literals;
  const auto frames = frames_for(position, 0, std::vector<std::uint8_t>(20, 0x11));
  for (const auto pause : {750ms, 751ms}) {
    FastPacketAssembler assembler;
    Nmea2000::Decoder decoder;
    auto now = 1s + 0ms;
    for (const auto& frame : frames) {
      hear(assembler, frame, now);
      decoder.receive(frame, now);
      now += pause;
    }
    const bool late = pause > 750ms;
    EXPECT_EQ(assembler.counters().messages, late ? 0u : 1u);
    EXPECT_EQ(assembler.counters().dropped, late ? 1u : 0u);
    EXPECT_EQ(assembler.counters().headless, 0u) << "its rest is no other message";
    EXPECT_EQ(decoder.counters().bad_checksums, 1u) << "dropped, or no position of 20 bytes";
  }
}

TEST(CutFastPackets, AFrameThatComesTwiceInARowIsTakenOnce) {
  const auto frames = frames_for(position, 0, std::vector<std::uint8_t>(43, 0x11));
  for (std::size_t twice = 0; twice < frames.size(); ++twice) {
    FastPacketAssembler assembler;
    for (std::size_t i = 0; i < frames.size(); ++i)
      for (std::size_t n = 0; n < (i == twice ? 2u : 1u); ++n) hear(assembler, frames[i]);
    EXPECT_EQ(assembler.counters().messages, 1u) << twice;
    EXPECT_EQ(assembler.counters().dropped + assembler.counters().headless, 0u) << twice;
  }
}

TEST(CutFastPackets, AMessageWhoseFramesChangedPlacesIsLostOnce) {
  for (std::size_t at = 0; at + 1 < 7; ++at) {
    auto frames = frames_for(position, 0, std::vector<std::uint8_t>(43, 0x11));
    std::swap(frames[at], frames[at + 1]);
    FastPacketAssembler assembler;
    for (const auto& frame : frames) hear(assembler, frame);
    const auto& counters = assembler.counters();
    EXPECT_EQ(counters.messages, 0u) << at;
    EXPECT_EQ(counters.dropped + counters.headless + assembler.unfinished(), at == 0 ? 2u : 1u)
        << at << ": only the first frame tells where a message begins";
  }
}

TEST(CutFastPackets, AMessageThatWaitsForItsEndIsUnfinished) {
  FastPacketAssembler assembler;
  auto frames = frames_for(position, 0, std::vector<std::uint8_t>(43, 0x11));
  frames.pop_back();
  for (const auto& frame : frames) hear(assembler, frame);
  EXPECT_EQ(assembler.unfinished(), 1u);
  Nmea2000::Decoder decoder;
  for (const auto& frame : frames) EXPECT_FALSE(decoder.receive(frame));
  decoder.finish();
  EXPECT_EQ(decoder.counters().bad_checksums, 1u);
}

}  // namespace cut_fast_packets_test
}  // namespace drydock::wire

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

void hear(FastPacketAssembler& assembler, const CanFrame& frame) {
  assembler.receive(j1939::parse_identifier(frame.id), frame.payload());
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

#include "drivers/wire/nmea2000/fast_packet.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/fields.hpp"
#include "drivers/wire/nmea2000/nmea2000.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire {
namespace fast_packet_test {

constexpr j1939::Identifier position{3, 129029, 255, 7};

struct Assembled {
  std::uint32_t pgn;
  std::uint8_t source;
  std::vector<std::uint8_t> data;
  bool operator==(const Assembled&) const = default;
};

/// Feeds frames to an assembler and keeps the messages.
struct Bench {
  FastPacketAssembler assembler;
  std::vector<Assembled> messages;
  void receive(const CanFrame& frame) {
    const auto id = j1939::parse_identifier(frame.id);
    if (const auto whole = assembler.receive(id, frame.payload())) {
      messages.push_back(
          {whole->id.pgn, whole->id.source, {whole->data.begin(), whole->data.end()}});
    }
  }
};

std::vector<CanFrame> frames_for(const j1939::Identifier& id, std::uint8_t sequence,
                                 const std::vector<std::uint8_t>& message) {
  std::vector<CanFrame> frames;
  for (std::size_t i = 0; i < fast_packet_frames(message.size()); ++i) {
    frames.push_back(encode_fast_packet(id, sequence, message, i));
  }
  return frames;
}

/// Parses canboat's plain format: `2022-09-28-11:36:59.668,3,129029,0,255,8,00,2f,...`.
std::optional<CanFrame> frame_of_plain(const std::string& line) {
  unsigned priority, pgn, source, destination, size;
  int at = 0;
  if (std::sscanf(line.c_str(), "%*[^,],%u,%u,%u,%u,%u%n", &priority, &pgn, &source, &destination,
                  &size, &at) != 5) {
    return std::nullopt;
  }
  CanFrame frame = j1939::blank_frame({static_cast<std::uint8_t>(priority), pgn,
                                       static_cast<std::uint8_t>(destination),
                                       static_cast<std::uint8_t>(source)});
  for (unsigned i = 0; i < size; ++i) {
    frame.data[i] =
        static_cast<std::uint8_t>(std::stoul(line.substr(at + 1 + 3 * i, 2), nullptr, 16));
  }
  frame.size = static_cast<std::uint8_t>(size);
  return frame;
}

TEST(FastPacket, LengthsFollowTheFrameLayout) {
  EXPECT_EQ(fast_packet_frames(0), 1u);
  EXPECT_EQ(fast_packet_frames(6), 1u);
  EXPECT_EQ(fast_packet_frames(7), 2u);
  EXPECT_EQ(fast_packet_frames(13), 2u);
  EXPECT_EQ(fast_packet_frames(14), 3u);
  EXPECT_EQ(fast_packet_frames(43), 7u);    // 129029
  EXPECT_EQ(fast_packet_frames(223), 32u);  // the longest
}

TEST(FastPacket, EncodesTheFramesOfARealMessage) {
  // Vessel position sent by a Garmin receiver, in canboat's test recombine-frames.
  const std::vector<std::uint8_t> message{
      0xE7, 0x95, 0x3D, 0x00, 0x73, 0xD6, 0x29, 0x00, 0xDA, 0x04, 0x73, 0xDB, 0xC9, 0xE5, 0x05,
      0x80, 0x7D, 0x02, 0x28, 0x5F, 0xD6, 0x10, 0xF6, 0x9B, 0x50, 0x6C, 0x05, 0x00, 0x00, 0x00,
      0x00, 0x13, 0xFC, 0x08, 0x6F, 0x00, 0xBE, 0x00, 0xDD, 0xF2, 0xFF, 0xFF, 0x00};
  const auto frames = frames_for({3, 129029, 255, 0}, 0, message);
  ASSERT_EQ(frames.size(), 7u);
  EXPECT_EQ(test::text_of(frames[0]), "0DF80500#002BE7953D0073D6");
  EXPECT_EQ(test::text_of(frames[1]), "0DF80500#012900DA0473DBC9");
  EXPECT_EQ(test::text_of(frames[6]), "0DF80500#06FF00FFFFFFFFFF");
}

RC_GTEST_PROP(FastPacket, InterleavedMessagesComeOutWhole, ()) {
  // Up to four talkers. Each sends in order; the order between talkers is random.
  std::vector<std::vector<CanFrame>> queues;
  std::vector<Assembled> sent;
  const auto talkers = *rc::gen::inRange(1, 5);
  for (int i = 0; i < talkers; ++i) {
    const j1939::Identifier id{6, 129540, 255, static_cast<std::uint8_t>(i)};
    const auto message = *rc::gen::container<std::vector<std::uint8_t>>(
        *rc::gen::inRange<std::size_t>(0, 224), rc::gen::arbitrary<std::uint8_t>());
    sent.push_back({id.pgn, id.source, message});
    queues.push_back(frames_for(id, *rc::gen::inRange<std::uint8_t>(0, 8), message));
  }
  Bench bench;
  std::vector<std::size_t> turns;
  for (std::size_t i = 0; i < queues.size(); ++i) turns.insert(turns.end(), queues[i].size(), i);
  std::shuffle(turns.begin(), turns.end(), std::mt19937{*rc::gen::arbitrary<unsigned>()});
  std::vector<std::size_t> next(queues.size(), 0);
  for (const std::size_t i : turns) bench.receive(queues[i][next[i]++]);
  RC_ASSERT(bench.messages.size() == sent.size());
  for (const auto& message : sent) {
    RC_ASSERT(std::count(bench.messages.begin(), bench.messages.end(), message) == 1);
  }
  RC_ASSERT(bench.assembler.counters().dropped == 0u);
}

RC_GTEST_PROP(FastPacket, ALostFrameDropsItsMessageAndNoOther, ()) {
  const std::vector<std::uint8_t> first(*rc::gen::inRange<std::size_t>(7, 224), 0x11);
  const std::vector<std::uint8_t> second(*rc::gen::inRange<std::size_t>(7, 224), 0x22);
  auto frames = frames_for(position, 1, first);
  const auto lost = *rc::gen::inRange<std::size_t>(0, frames.size());
  frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(lost));
  const auto sequence = *rc::gen::element<std::uint8_t>(1, 2);
  for (const auto& frame : frames_for(position, sequence, second)) frames.push_back(frame);
  Bench bench;
  for (const auto& frame : frames) bench.receive(frame);
  RC_ASSERT(bench.messages.size() == 1u);
  RC_ASSERT(bench.messages[0].data == second);
}

TEST(FastPacket, FrameZeroIsNeverGluedOntoAStaleBody) {
  Bench bench;
  const std::vector<std::uint8_t> old_message(20, 0x11), new_message(20, 0x22);
  const auto old_frames = frames_for(position, 0, old_message);
  const auto new_frames = frames_for(position, 0, new_message);
  bench.receive(old_frames[0]);
  bench.receive(old_frames[1]);
  bench.receive(new_frames[0]);
  bench.receive(old_frames[2]);  // the last frame of the old message completes nothing
  EXPECT_TRUE(bench.messages.empty());
  EXPECT_EQ(bench.assembler.counters().dropped, 2u);
}

TEST(FastPacket, BeyondItsFixedStorageItDropsTheMessageIdleLongest) {
  Bench bench;
  const std::vector<std::uint8_t> message(8, 0x33);
  const auto talkers = FastPacketAssembler::max_concurrent + 1;
  for (std::uint8_t source = 0; source < talkers; ++source) {
    bench.receive(encode_fast_packet({3, 129029, 255, source}, 0, message, 0));
  }
  EXPECT_EQ(bench.assembler.counters().dropped, 1u);
  for (std::uint8_t source = 0; source < talkers; ++source) {
    bench.receive(encode_fast_packet({3, 129029, 255, source}, 0, message, 1));
  }
  EXPECT_EQ(bench.messages.size(), FastPacketAssembler::max_concurrent);
  EXPECT_EQ(bench.messages.front().source, 1);
  EXPECT_EQ(bench.assembler.counters().stray, 1u);
}

TEST(FastPacket, LengthsBeyond223BytesAndEmptyFramesAreStray) {
  Bench bench;
  bench.receive(test::frame("0DF80500#00E0000000000000"));
  bench.receive(test::frame("0DF80500#00"));
  bench.receive(test::frame("0DF80500#"));
  EXPECT_EQ(bench.assembler.counters().stray, 3u);
  EXPECT_TRUE(bench.messages.empty());
}

TEST(FastPacket, RecombinesTheOrderedMessagesOfCanboatsTest) {
  const auto lines = test::lines_of(test::corpus("n2k/canboat/analyzer_tests/recombine-frames.in"));
  if (lines.empty()) GTEST_SKIP() << "corpora absent: n2k";
  Bench bench;
  for (const auto& line : lines) {
    const auto frame = frame_of_plain(line);
    const auto pgn = frame ? j1939::parse_identifier(frame->id).pgn : 0;
    if (pgn == 129029 || pgn == 126720 || pgn == 130823) bench.receive(*frame);
  }
  // Two of canboat's seven fast packets arrive out of order. The assembler drops them by design.
  ASSERT_EQ(bench.messages.size(), 5u);
  const std::vector<std::uint32_t> pgns{129029, 129029, 126720, 130823, 129029};
  const std::vector<std::size_t> sizes{47, 47, 62, 223, 47};
  for (std::size_t i = 0; i < pgns.size(); ++i) {
    EXPECT_EQ(bench.messages[i].pgn, pgns[i]);
    EXPECT_EQ(bench.messages[i].data.size(), sizes[i]);
  }
  // The last message is the retransmission. Its first frame was not joined to the old message (E5,
  // not E6).
  EXPECT_EQ(bench.messages.back().data[13], 0xE5);
  const auto fix = nmea2000::decode<nmea2000::GnssPosition>(0, bench.messages[0].data).value();
  EXPECT_NEAR(degrees(*fix.latitude_rad), 42.4967684, 1e-7);
  EXPECT_NEAR(degrees(*fix.longitude_rad), -71.5836637, 1e-7);
  EXPECT_NEAR(*fix.altitude_m, 90.984603, 1e-6);
  EXPECT_EQ(fix.satellites, 8);
  EXPECT_NEAR(*fix.horizontal_dop, 1.11, 1e-9);
}

/// PGN 129540: SID, mode, count, then 12 bytes for each satellite.
bool agrees_with_gpsd(const Assembled& message, const nlohmann::json& satellites) {
  const Bytes data = message.data;
  if (data.size() < 3 || data[2] != satellites.size()) return false;
  for (std::size_t i = 0; i < satellites.size(); ++i) {
    const std::size_t at = 3 + 12 * i;
    const double to_deg = 1e-4 * 180 / std::numbers::pi;
    const auto near = [&](const char* key, double ours, double within) {
      return !satellites[i].contains(key) ||
             std::abs(satellites[i][key].get<double>() - ours) <= within;
    };
    if (!near("PRN", data[at], 0) ||
        !near("el", load_le<std::int16_t>(data, at + 1) * to_deg, 0.51) ||
        !near("az", load_le<std::uint16_t>(data, at + 3) * to_deg, 0.51) ||
        !near("ss", load_le<std::int16_t>(data, at + 5) * 0.01, 0.051)) {
      return false;
    }
  }
  return true;
}

TEST(FastPacket, RecombinesThousandsOfSatelliteFramesAsGpsdDoes) {
  const std::string log = test::corpus("n2k/gpsd/logfile_20140914_365495765_can.log");
  const auto frames = test::frames_of_log(log);
  if (frames.empty()) GTEST_SKIP() << "corpora absent: n2k";
  Bench bench;
  std::size_t fed = 0;
  for (const CanFrame& frame : frames) {
    if (j1939::parse_identifier(frame.id).pgn != 129540) continue;
    ++fed;
    bench.receive(frame);
  }
  EXPECT_EQ(fed, 4517u);
  std::size_t next = 0, agreed = 0, reported = 0;
  for (const auto& line : test::lines_of(log + ".chk")) {
    const auto sky = nlohmann::json::parse(line, nullptr, false);
    if (!sky.is_object() || sky["class"] != "SKY" || !sky.contains("satellites")) continue;
    ++reported;
    std::size_t found = next;
    while (found < bench.messages.size() &&
           !agrees_with_gpsd(bench.messages[found], sky["satellites"])) {
      ++found;
    }
    if (found == bench.messages.size()) continue;
    ++agreed;
    next = found + 1;
  }
  EXPECT_GT(reported, 200u);
  EXPECT_EQ(agreed, reported);
}

}  // namespace fast_packet_test
}  // namespace drydock::wire

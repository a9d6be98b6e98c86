#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>

#include "drivers/wire/registry.hpp"
#include "tests/drivers/property.hpp"
#include "tests/drivers/wire/golden_protocols.hpp"

/// Rules for every byte protocol, checked with golden bytes from other software.
namespace drydock::wire::testing {
namespace conformance_test {

class ByteProtocol : public ::testing::TestWithParam<GoldenProtocol> {
 protected:
  static StreamSeen read(Bytes stream, const std::vector<std::size_t>& pieces = {1u << 20}) {
    return GetParam().read(stream, pieces);
  }

  static void expect_counters_add_up(const StreamSeen& reading, std::size_t bytes) {
    EXPECT_EQ(reading.counters.bytes_in, bytes);
    EXPECT_EQ(reading.counters.bytes_good + reading.counters.bytes_skipped + reading.held, bytes);
    EXPECT_EQ(reading.counters.frames, reading.frames.size());
  }

  /// Expects all golden frames in order. The stream gets enough quiet noise to end any wait for a
  /// false length.
  static void expect_all_golden_frames_in(const Buffer& stream, const Buffer& golden) {
    const auto expected = read(golden).frames;
    const auto reading = read(stream + Buffer(GetParam().max_frame, 0x00));
    auto next = reading.frames.begin();
    for (const Buffer& frame : expected) {
      next = std::find(next, reading.frames.end(), frame);
      ASSERT_NE(next, reading.frames.end()) << "frame lost";
      ++next;
    }
    expect_counters_add_up(reading, stream.size() + GetParam().max_frame);
  }
};

/// Random bytes and parts of real frames.
Buffer noise(const Buffer& golden) {
  const auto begin = *rc::gen::inRange<std::size_t>(0, golden.size());
  const auto end = *rc::gen::inRange<std::size_t>(begin, golden.size());
  const Buffer torn(golden.begin() + static_cast<long>(begin),
                    golden.begin() + static_cast<long>(end));
  return *rc::gen::arbitrary<Buffer>() + torn + *rc::gen::arbitrary<Buffer>();
}

TEST_P(ByteProtocol, TakesEveryGoldenFrameAndNoByteMore) {
  const Buffer& stream = GetParam().stream;
  const auto reading = read(stream);
  EXPECT_EQ(reading.frames.size(), GetParam().frames);
  EXPECT_EQ(reading.keys.size(), GetParam().messages);
  EXPECT_EQ(reading.counters.bytes_good, stream.size());
  EXPECT_EQ(reading.counters.bad_checksums, 0u);
}

TEST_P(ByteProtocol, SeesTheSameInAnySplit) {
  const Buffer& stream = GetParam().stream;
  const auto whole = read(stream);
  EXPECT_TRUE(holds([&] {
    const auto pieces = *rc::gen::nonEmpty(
        rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(1, 120)));
    const auto split = read(stream, pieces);
    RC_ASSERT(split.frames == whole.frames);
    RC_ASSERT(split.counters == whole.counters);
  }));
}

TEST_P(ByteProtocol, SplitNoiseCountsLikeWholeNoise) {
  const Buffer& golden = GetParam().stream;
  EXPECT_TRUE(holds([&] {
    const Buffer stream = noise(golden) + golden + noise(golden);
    const auto whole = read(stream);
    const auto bytewise = read(stream, {1});
    RC_ASSERT(bytewise.frames == whole.frames);
    RC_ASSERT(bytewise.counters == whole.counters);
  }));
}

TEST_P(ByteProtocol, FindsEveryFrameBetweenNoise) {
  const Buffer& golden = GetParam().stream;
  EXPECT_TRUE(holds([&] {
    const Buffer stream = noise(golden) + golden + noise(golden);
    expect_all_golden_frames_in(stream, golden);
    RC_ASSERT(!::testing::Test::HasFailure());
  }));
}

TEST_P(ByteProtocol, LosesNoFrameBehindAFalseSync) {
  const Buffer& golden = GetParam().stream;
  const Buffer& sync = GetParam().false_sync;
  for (std::size_t n = 1; n <= sync.size(); ++n) {
    const Buffer head(sync.begin(), sync.begin() + static_cast<long>(n));
    expect_all_golden_frames_in(head + golden, golden);
  }
}

TEST_P(ByteProtocol, LosesNoFrameBehindADamagedOne) {
  const Buffer& golden = GetParam().stream;
  Buffer damaged = read(golden).frames.front();
  damaged[GetParam().inside] ^= 0x01;
  const auto reading = read(damaged + golden);
  EXPECT_EQ(reading.frames.size(), GetParam().frames);
  EXPECT_GE(reading.counters.bad_checksums, 1u);
  expect_counters_add_up(reading, damaged.size() + golden.size());
}

TEST_P(ByteProtocol, LosesNoFrameBehindATruncatedOne) {
  const Buffer& golden = GetParam().stream;
  const Buffer first = read(golden).frames.front();
  for (std::size_t n = 1; n < first.size(); ++n) {
    const Buffer cut(first.begin(), first.begin() + static_cast<long>(n));
    expect_all_golden_frames_in(cut + golden, golden);
  }
}

TEST_P(ByteProtocol, NoBytesMakeAFrameWithAWrongChecksum) {
  const Buffer& golden = GetParam().stream;
  EXPECT_TRUE(holds([&] {
    Buffer stream = golden;
    const auto changes = *rc::gen::arbitrary<std::vector<std::pair<std::uint32_t, std::uint8_t>>>();
    for (const auto& [at, value] : changes) stream[at % stream.size()] = value;
    const auto reading = read(stream);
    for (const Buffer& frame : reading.frames) RC_ASSERT(GetParam().sound(frame));
    expect_counters_add_up(reading, stream.size());
  }));
}

TEST_P(ByteProtocol, DecodesAnyFrameShapedBytesWithoutHarm) {
  const auto frames = read(GetParam().stream).frames;
  EXPECT_TRUE(holds([&] {
    Buffer frame = *rc::gen::elementOf(frames);
    frame.resize(*rc::gen::inRange<std::size_t>(1, frame.size() + 1));
    const auto changes = *rc::gen::arbitrary<std::vector<std::pair<std::uint16_t, std::uint8_t>>>();
    for (const auto& [at, value] : changes) frame[at % frame.size()] = value;
    GetParam().decode(frame);
  }));
}

TEST_P(ByteProtocol, MessagesNameTheirFieldsOnce) {
  for (const auto& keys : read(GetParam().stream).keys) {
    EXPECT_FALSE(keys.front().empty());
    std::vector<std::string> fields(keys.begin() + 1, keys.end());
    std::ranges::sort(fields);
    EXPECT_EQ(std::ranges::adjacent_find(fields), fields.end());
  }
}

INSTANTIATE_TEST_SUITE_P(Every, ByteProtocol, ::testing::ValuesIn(golden_protocols()),
                         [](const auto& row) {
                           std::string name{row.param.name};
                           std::ranges::replace_if(
                               name, [](unsigned char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

template <class... P>
std::vector<std::string_view> names(ProtocolList<P...>) {
  return {P::name...};
}

TEST(ByteProtocols, HaveGoldenBytesEach) {
  std::vector<std::string_view> golden;
  golden.reserve(golden_protocols().size());
  for (const auto& protocol : golden_protocols()) golden.push_back(protocol.name);
  EXPECT_THAT(golden, ::testing::UnorderedElementsAreArray(names(BytesProtocols{})));
}

}  // namespace conformance_test
}  // namespace drydock::wire::testing

#include <gmock/gmock.h>

#include "tests/drivers/described/golden_descriptions.hpp"
#include "tests/drivers/property.hpp"
#include "tests/test_name.hpp"

/// The rules of every byte protocol (tests/drivers/wire/conformance_test.cpp), for each shipped
/// description of bytes.
namespace drydock::described::test {
namespace conformance_test {

using namespace wire::testing;
using wire::testing::operator+;  // surveyed_buses.hpp has one of frames, which hides it
using wire::Bytes;

struct Seen {
  std::vector<Buffer> frames;
  std::size_t messages = 0;
  wire::StreamCounters counters;
  std::size_t held = 0;
};

class DescribedProtocolTest : public ::testing::TestWithParam<GoldenDescription> {
 protected:
  static constexpr std::size_t longest = wire::described::longest_frame;

  /// The last size of the pieces is repeated.
  Seen read(Bytes stream, const std::vector<std::size_t>& pieces = {1u << 20}) const {
    Seen seen;
    const auto framer = std::make_unique<wire::Framer<longest>>();
    for (std::size_t i = 0; !stream.empty(); ++i) {
      const auto size = std::min(pieces[std::min(i, pieces.size() - 1)], stream.size());
      framer->feed(
          stream.first(size), [&](Bytes bytes) { return codec_.scan(bytes); },
          [&](Bytes frame, std::size_t) {
            seen.frames.emplace_back(frame.begin(), frame.end());
            seen.messages += codec_.decode(frame).has_value();
          });
      stream = stream.subspan(size);
    }
    seen.counters = framer->counters();
    seen.held = framer->held();
    return seen;
  }

  static void expect_counters_add_up(const Seen& seen, std::size_t bytes) {
    EXPECT_EQ(seen.counters.bytes_in, bytes);
    EXPECT_EQ(seen.counters.bytes_good + seen.counters.bytes_skipped + seen.held, bytes);
    EXPECT_EQ(seen.counters.frames, seen.frames.size());
  }

  /// A checksum of 8 bits is right by chance once in 256: then the frame is one, and takes the
  /// bytes of others.
  bool is_there_by_chance(const Buffer& frame, const std::vector<Buffer>& golden_frames) const {
    return codec_.description->plan.checksum.size() == 1 && GetParam().sound(frame) &&
           std::ranges::find(golden_frames, frame) == golden_frames.end();
  }

  /// Expects all golden frames in order. Quiet noise behind them ends any wait for a false length.
  void expect_all_golden_frames_in(const Buffer& stream) const {
    const auto expected = read(golden()).frames;
    const auto seen = read(stream + Buffer(longest, 0x00));
    expect_counters_add_up(seen, stream.size() + longest);
    for (const Buffer& frame : seen.frames)
      if (is_there_by_chance(frame, expected)) return;
    auto next = seen.frames.begin();
    for (const Buffer& frame : expected) {
      next = std::find(next, seen.frames.end(), frame);
      ASSERT_NE(next, seen.frames.end()) << "frame lost";
      ++next;
    }
  }

  static const Buffer& golden() { return GetParam().stream; }
  bool has_checksum() const { return codec_.description->plan.checksum.size() != 0; }

  wire::described::DescribedCodec codec_{shipped(GetParam().file)};
};

Buffer noise(const Buffer& golden) {
  const auto begin = *rc::gen::inRange<std::size_t>(0, golden.size());
  const auto end = *rc::gen::inRange<std::size_t>(begin, golden.size());
  const Buffer torn(golden.begin() + static_cast<long>(begin),
                    golden.begin() + static_cast<long>(end));
  return *rc::gen::arbitrary<Buffer>() + torn + *rc::gen::arbitrary<Buffer>();
}

TEST_P(DescribedProtocolTest, TakesEveryGoldenFrameAndNoByteMore) {
  const auto seen = read(golden());
  EXPECT_EQ(seen.frames.size(), GetParam().frames);
  EXPECT_EQ(seen.messages, GetParam().messages);
  EXPECT_EQ(seen.counters.bytes_good, golden().size());
  EXPECT_EQ(seen.counters.bad_checksums, 0u);
}

TEST_P(DescribedProtocolTest, SeesTheSameInAnySplit) {
  EXPECT_TRUE(holds([&] {
    const Buffer stream = noise(golden()) + golden() + noise(golden());
    const auto whole = read(stream);
    const auto pieces = *rc::gen::nonEmpty(
        rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(1, 60)));
    const auto split = read(stream, pieces), bytewise = read(stream, {1});
    RC_ASSERT(split.frames == whole.frames);
    RC_ASSERT(split.counters == whole.counters);
    RC_ASSERT(bytewise.counters == whole.counters);
  }));
}

TEST_P(DescribedProtocolTest, FindsEveryFrameBetweenBytesOfAnyKind) {
  EXPECT_TRUE(holds([&] {
    // A line has no checksum: digits in front of it would be part of its number.
    const Buffer before = noise(golden()) + as_bytes("\n");
    expect_all_golden_frames_in(before + golden() + noise(golden()));
    RC_ASSERT(!::testing::Test::HasFailure());
  }));
}

TEST_P(DescribedProtocolTest, LosesNoFrameBehindAFalseSyncOrATruncatedFrame) {
  const Buffer first = read(golden()).frames.front();
  for (const Buffer& cause : {GetParam().false_sync, first})
    for (std::size_t n = 1; n < cause.size(); ++n)
      expect_all_golden_frames_in(Buffer(cause.begin(), cause.begin() + static_cast<long>(n)) +
                                  golden());
}

TEST_P(DescribedProtocolTest, LosesNoFrameBehindADamagedOne) {
  Buffer damaged = read(golden()).frames.front();
  damaged[GetParam().inside] ^= 0x01;
  const auto seen = read(damaged + golden());
  EXPECT_EQ(seen.frames.size(), GetParam().frames);
  EXPECT_GE(seen.counters.bad_checksums, has_checksum() ? 1u : 0u);
  expect_counters_add_up(seen, damaged.size() + golden().size());
}

TEST_P(DescribedProtocolTest, NoBytesMakeAFrameThatItsChecksumRefuses) {
  EXPECT_TRUE(holds([&] {
    Buffer stream = golden();
    const auto changes = *rc::gen::arbitrary<std::vector<std::pair<std::uint32_t, std::uint8_t>>>();
    for (const auto& [at, value] : changes) stream[at % stream.size()] = value;
    const auto seen = read(stream);
    for (const Buffer& frame : seen.frames) RC_ASSERT(GetParam().sound(frame));
    expect_counters_add_up(seen, stream.size());
  }));
}

TEST_P(DescribedProtocolTest, DecodesAnyFrameShapedBytesWithoutHarm) {
  const auto frames = read(golden()).frames;
  EXPECT_TRUE(holds([&] {
    Buffer frame = *rc::gen::elementOf(frames);
    frame.resize(*rc::gen::inRange<std::size_t>(1, frame.size() + 1));
    const auto changes = *rc::gen::arbitrary<std::vector<std::pair<std::uint16_t, std::uint8_t>>>();
    for (const auto& [at, value] : changes) frame[at % frame.size()] = value;
    if (const auto message = codec_.decode(frame))
      visit_fields(std::get<0>(*message), [](std::string_view, const auto& value) {
        if constexpr (requires { value.has_value(); }) RC_ASSERT(!value || std::isfinite(*value));
      });
  }));
}

INSTANTIATE_TEST_SUITE_P(Every, DescribedProtocolTest, ::testing::ValuesIn(golden_descriptions()),
                         [](const auto& one) { return drydock::test::test_name(one.param.file); });

TEST(DescribedProtocols, EachShippedDescriptionOfBytesHasGoldenOnes) {
  std::vector<std::string> bytes, golden;
  for (const auto& one : rig_config::shipped_descriptions())
    if (!one->frames) bytes.push_back(one->name);
  for (const auto& one : golden_descriptions()) golden.push_back(one.file);
  EXPECT_THAT(golden, ::testing::UnorderedElementsAreArray(bytes));
}

}  // namespace conformance_test
}  // namespace drydock::described::test

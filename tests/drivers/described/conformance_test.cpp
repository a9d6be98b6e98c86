#include <numeric>

#include "tests/drivers/described/support.hpp"
#include "tests/drivers/property.hpp"

/// The rules of every byte protocol (tests/drivers/wire/conformance_test.cpp), for descriptions.
namespace drydock::described::test {
namespace {

using namespace wire::testing;
using wire::Bytes;

/// A shipped description as a codec with static functions.
template <class Of>
struct Shipped {
  static constexpr std::size_t max_frame = wire::described::longest_frame;
  using Message = std::variant<wire::described::Record>;
  static const wire::described::DescribedCodec& codec() {
    static const wire::described::DescribedCodec one(shipped(Of::file));
    return one;
  }
  static wire::Scan scan(Bytes bytes) { return codec().scan(bytes); }
  static std::optional<Message> decode(Bytes frame) { return codec().decode(frame); }
  static Buffer golden() { return fixture(std::string("described/") + Of::golden); }
};

bool xor_is_right(Bytes frame) {
  const auto text = as_text(frame);
  const auto star = text.rfind('*');
  if (star == text.npos || (text[0] != '$' && text[0] != '!') || star + 3 > text.size())
    return false;
  const int sum = std::accumulate(text.begin() + 1, text.begin() + static_cast<long>(star), 0,
                                  [](int x, char c) { return x ^ c; });
  return std::stoi(std::string(text.substr(star + 1, 2)), nullptr, 16) == sum;
}

/// Modbus, bit by bit: the CRC over content and CRC in its own order is 0.
bool modbus_is_right(Bytes frame) {
  Buffer turned(frame.begin(), frame.end());
  std::swap(turned[turned.size() - 1], turned[turned.size() - 2]);
  unsigned crc = 0xFFFF;
  for (const unsigned byte : turned) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xA001 : crc >> 1;
  }
  return crc == 0;
}

bool smbus_is_right(Bytes frame) {
  const auto text = as_text(frame);
  const auto star = text.rfind('*');
  if (star == text.npos || text[0] != 'w') return false;
  unsigned crc = 0;
  for (const char c : text.substr(0, star)) {
    for (int bit = 7; bit >= 0; --bit) {
      const unsigned carry = crc >> 7 ^ (static_cast<unsigned char>(c) >> bit & 1u);
      crc = (crc << 1 & 0xFF) ^ (carry ? 7 : 0);
    }
  }
  return std::stoul(std::string(text.substr(star + 1, 2)), nullptr, 16) == crc;
}

struct Valeport {
  static constexpr const char *file = "valeport-vat.toml", *golden = "valeport-vat.txt";
  static constexpr std::size_t frames = 3, messages = 3, inside = 9;
  static Buffer false_sync() { return as_bytes("$PRVAT,12"); }
  static bool sound(Bytes frame) { return xor_is_right(frame); }
};
struct Sounder {
  static constexpr const char *file = "nmea-depth.toml", *golden = "nmea-depth.txt";
  static constexpr std::size_t frames = 8, messages = 7, inside = 9;
  static Buffer false_sync() { return as_bytes("$SDDBT,1"); }
  static bool sound(Bytes frame) { return xor_is_right(frame); }
};
struct Keller {
  static constexpr const char *file = "keller.toml", *golden = "keller.bin";
  static constexpr std::size_t frames = 6, messages = 6, inside = 2;
  static Buffer false_sync() { return {0xFA, 0x49, 0x40}; }
  static bool sound(Bytes frame) { return modbus_is_right(frame); }
};
struct Digiquartz {
  static constexpr const char *file = "digiquartz.toml", *golden = "digiquartz.txt";
  static constexpr std::size_t frames = 4, messages = 4, inside = 3;
  static Buffer false_sync() { return as_bytes("*00"); }
  static bool sound(Bytes frame) { return as_text(frame).starts_with("*0001"); }
};
struct Cerulean {
  static constexpr const char *file = "cerulean-dvpdl.toml", *golden = "cerulean-dvpdl.txt";
  static constexpr std::size_t frames = 2, messages = 2, inside = 9;
  static Buffer false_sync() { return as_bytes("$DVPDL,1"); }
  static bool sound(Bytes frame) { return xor_is_right(frame); }
};
struct WaterLinkedWrz {
  static constexpr const char *file = "water-linked-wrz.toml", *golden = "water-linked-wrz.txt";
  static constexpr std::size_t frames = 3, messages = 3, inside = 8;
  static Buffer false_sync() { return as_bytes("wrz,0.1,"); }
  static bool sound(Bytes frame) { return smbus_is_right(frame); }
};
struct Mip {
  static constexpr const char *file = "mip-imu.toml", *golden = "mip.bin";
  static constexpr std::size_t frames = 2, messages = 2, inside = 4;
  static Buffer false_sync() { return {0x75, 0x65, 0x80, 0x2A}; }
  static bool sound(Bytes frame) {
    unsigned a = 0, b = 0;
    for (const unsigned byte : frame.first(frame.size() - 2)) b += a += byte;
    return frame[frame.size() - 2] == a % 256 && frame.back() == b % 256;
  }
};

template <class Of>
class DescribedProtocolTest : public ::testing::Test {};
using All = ::testing::Types<Valeport, Sounder, Keller, Digiquartz, Cerulean, WaterLinkedWrz, Mip>;
TYPED_TEST_SUITE(DescribedProtocolTest, All);

template <class Of>
void expect_all_golden_frames_in(const Buffer& stream) {
  using P = Shipped<Of>;
  const auto expected = read_stream<P>(P::golden()).frames;
  const auto reading = read_stream<P>(stream + Buffer(P::max_frame, 0x00));
  for (const Buffer& frame : expected)
    EXPECT_NE(std::ranges::find(reading.frames, frame), reading.frames.end()) << "frame lost";
  EXPECT_EQ(reading.counters.bytes_good + reading.counters.bytes_skipped + reading.held,
            reading.counters.bytes_in);
}

Buffer noise(const Buffer& golden) {
  const auto begin = *rc::gen::inRange<std::size_t>(0, golden.size());
  const auto end = *rc::gen::inRange<std::size_t>(begin, golden.size());
  const Buffer torn(golden.begin() + static_cast<long>(begin),
                    golden.begin() + static_cast<long>(end));
  return *rc::gen::arbitrary<Buffer>() + torn + *rc::gen::arbitrary<Buffer>();
}

TYPED_TEST(DescribedProtocolTest, TakesEveryGoldenFrameAndNoByteMore) {
  using P = Shipped<TypeParam>;
  const auto reading = read_stream<P>(P::golden());
  EXPECT_EQ(reading.frames.size(), TypeParam::frames);
  EXPECT_EQ(reading.messages.size(), TypeParam::messages);
  EXPECT_EQ(reading.counters.bytes_good, P::golden().size());
  EXPECT_EQ(reading.counters.bad_checksums, 0u);
}

TYPED_TEST(DescribedProtocolTest, SeesTheSameInAnySplit) {
  using P = Shipped<TypeParam>;
  const Buffer golden = P::golden();
  EXPECT_TRUE(holds([&] {
    const Buffer stream = noise(golden) + golden + noise(golden);
    const auto whole = read_stream<P>(stream);
    const auto pieces = *rc::gen::nonEmpty(
        rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(1, 60)));
    const auto split = read_stream<P>(stream, pieces);
    const auto bytewise = read_stream<P>(stream, {1});
    RC_ASSERT(split.frames == whole.frames);
    RC_ASSERT(split.counters == whole.counters);
    RC_ASSERT(bytewise.counters == whole.counters);
  }));
}

TYPED_TEST(DescribedProtocolTest, FindsEveryFrameBetweenBytesOfAnyKind) {
  const Buffer golden = Shipped<TypeParam>::golden();
  EXPECT_TRUE(holds([&] {
    // A line has no checksum: digits in front of it would be part of its number.
    const Buffer before = noise(golden) + as_bytes("\n");
    expect_all_golden_frames_in<TypeParam>(before + golden + noise(golden));
    RC_ASSERT(!::testing::Test::HasFailure());
  }));
}

TYPED_TEST(DescribedProtocolTest, LosesNoFrameBehindAFalseSyncOrATruncatedFrame) {
  using P = Shipped<TypeParam>;
  const Buffer golden = P::golden(), sync = TypeParam::false_sync();
  const Buffer first = read_stream<P>(golden).frames.front();
  for (const Buffer& cause : {sync, first})
    for (std::size_t n = 1; n < cause.size(); ++n)
      expect_all_golden_frames_in<TypeParam>(
          Buffer(cause.begin(), cause.begin() + static_cast<long>(n)) + golden);
}

TYPED_TEST(DescribedProtocolTest, NoBytesMakeAFrameThatItsChecksumRefuses) {
  using P = Shipped<TypeParam>;
  const Buffer golden = P::golden();
  EXPECT_TRUE(holds([&] {
    Buffer stream = golden;
    const auto changes = *rc::gen::arbitrary<std::vector<std::pair<std::uint32_t, std::uint8_t>>>();
    for (const auto& [at, value] : changes) stream[at % stream.size()] = value;
    for (const Buffer& frame : read_stream<P>(stream).frames) RC_ASSERT(TypeParam::sound(frame));
  }));
}

TYPED_TEST(DescribedProtocolTest, DecodesAnyFrameShapedBytesWithoutHarm) {
  using P = Shipped<TypeParam>;
  const auto frames = read_stream<P>(P::golden()).frames;
  EXPECT_TRUE(holds([&] {
    Buffer frame = *rc::gen::elementOf(frames);
    frame.resize(*rc::gen::inRange<std::size_t>(1, frame.size() + 1));
    const auto changes = *rc::gen::arbitrary<std::vector<std::pair<std::uint16_t, std::uint8_t>>>();
    for (const auto& [at, value] : changes) frame[at % frame.size()] = value;
    if (const auto message = P::decode(frame))
      visit_fields(std::get<0>(*message), [](std::string_view, const auto& value) {
        if constexpr (requires { value.has_value(); }) RC_ASSERT(!value || std::isfinite(*value));
      });
  }));
}

}  // namespace
}  // namespace drydock::described::test

#include <gtest/gtest.h>

#include <numeric>

#include "drivers/wire/registry.hpp"
#include "tests/drivers/property.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// Rules for every byte protocol, checked with golden bytes from other software.
namespace drydock::wire::testing {
namespace conformance_test {

/// The golden stream of a protocol, its frames and messages, and the form of its sync.
template <class P>
struct Golden;

template <>
struct Golden<Nmea0183> {
  static Buffer stream() { return fixture("nmea0183/golden.nmea"); }
  static constexpr std::size_t frames = 28, messages = 28;
  static Buffer false_sync() { return as_bytes("$GPGGA,12"); }
  static constexpr std::size_t inside = 9;  ///< offset of a byte that the checksum covers
};

template <>
struct Golden<Ubx> {
  static Buffer stream() { return fixture("ubx/golden.ubx"); }
  static constexpr std::size_t frames = 20, messages = 19;
  static Buffer false_sync() { return {0xB5, 0x62, 0x01, 0x07, 0x5C, 0x00}; }
  static constexpr std::size_t inside = 8;
};

template <>
struct Golden<UbxNmea> {
  static Buffer stream() { return Golden<Ubx>::stream() + Golden<Nmea0183>::stream(); }
  static constexpr std::size_t frames = 48, messages = 47;
  static Buffer false_sync() { return {0xB5, 0x62, 0x01, 0x07, 0x5C, 0x00, '$', 'G', 'P'}; }
  static constexpr std::size_t inside = 8;
};

template <>
struct Golden<Pd0> {
  static Buffer stream() { return fixture("pd0/golden.pd0"); }
  static constexpr std::size_t frames = 5, messages = 4;
  static Buffer false_sync() { return {0x7F, 0x7F, 0xD9, 0x00, 0x00, 0x03}; }
  static constexpr std::size_t inside = 20;
};

template <>
struct Golden<Pd4> {
  static Buffer stream() { return fixture("pd4/golden.pd4"); }
  static constexpr std::size_t frames = 2, messages = 2;
  static Buffer false_sync() { return {0x7D, 0x00, 0x2D, 0x00, 0x43}; }
  static constexpr std::size_t inside = 20;
};

template <>
struct Golden<Pd5> {
  static Buffer stream() { return fixture("pd5/golden.pd5"); }
  static constexpr std::size_t frames = 2, messages = 2;
  static Buffer false_sync() { return {0x7D, 0x01, 0x56, 0x00, 0x43}; }
  static constexpr std::size_t inside = 60;
};

template <>
struct Golden<Pd6> {
  static Buffer stream() { return fixture("pd6/golden.pd6"); }
  static constexpr std::size_t frames = 18, messages = 17;
  static Buffer false_sync() { return as_bytes(":BI,  +12"); }
  static constexpr std::size_t inside = 7;  ///< the point: no checksum covers the digits
};

template <>
struct Golden<WaterLinked> {
  static Buffer stream() { return fixture("water-linked/golden.txt"); }
  static constexpr std::size_t frames = 20, messages = 19;
  static Buffer false_sync() { return as_bytes("wrz,0.1,"); }
  static constexpr std::size_t inside = 8;
};

template <>
struct Golden<WaterLinkedJson> {
  static Buffer stream() { return fixture("water-linked-json/golden.jsonl"); }
  static constexpr std::size_t frames = 21, messages = 19;
  static Buffer false_sync() { return as_bytes("{\"time\":1,\"vx"); }
  static constexpr std::size_t inside = 7;  ///< a colon: no checksum covers the digits
};

template <>
struct Golden<Nortek> {
  static Buffer stream() { return fixture("nortek/golden.nmea"); }
  static constexpr std::size_t frames = 13, messages = 12;
  static Buffer false_sync() { return as_bytes("$PNORBT7,12"); }
  static constexpr std::size_t inside = 9;
};

template <>
struct Golden<NortekAd2cp> {
  static Buffer stream() { return fixture("nortek-ad2cp/golden.nortek-ad2cp"); }
  static constexpr std::size_t frames = 15, messages = 15;
  static Buffer false_sync() {
    return {0xA5, 0x0A, 0x1B, 0x10, 0xD4, 0x00, 0x21, 0xCC, 0x41, 0x9D};
  }
  static constexpr std::size_t inside = 20;
};

template <>
struct Golden<Wayfinder> {
  static Buffer stream() { return fixture("wayfinder/golden.wayfinder"); }
  static constexpr std::size_t frames = 7, messages = 7;
  static Buffer false_sync() { return {0xAA, 0x10, 0x01, 0x62, 0x00, 0x02}; }
  static constexpr std::size_t inside = 20;
};

/// The checksums again, written from the documents and not from the scanners.
bool sound_sentence(Bytes frame) {
  const std::string_view text = as_text(frame);
  const std::size_t star = text.rfind('*');
  if (text.empty() || text[0] != '$' || star == text.npos || star + 3 > text.size()) return false;
  const int sum = std::accumulate(text.begin() + 1, text.begin() + static_cast<long>(star), 0,
                                  [](int x, char c) { return x ^ c; });
  return std::stoi(std::string{text.substr(star + 1, 2)}, nullptr, 16) == sum;
}

bool sound_ubx(Bytes frame) {
  unsigned a = 0, b = 0;
  for (const auto byte : frame.subspan(2, frame.size() - 4)) b = (b + (a = (a + byte) % 256)) % 256;
  return frame[0] == 0xB5 && frame[1] == 0x62 && frame[frame.size() - 2] == a && frame.back() == b;
}

/// A command may omit the checksum: then there is no star before the line's end.
bool sound_water_linked(Bytes frame) {
  const std::string_view text = as_text(frame);
  const std::size_t star = text.find('*');
  if (star == text.npos) return text.starts_with("wc");
  unsigned crc = 0;
  for (const char c : text.substr(0, star)) {
    for (int bit = 7; bit >= 0; --bit) {
      const unsigned carry = crc >> 7 ^ (static_cast<unsigned char>(c) >> bit & 1u);
      crc = (crc << 1 & 0xFF) ^ (carry ? 7 : 0);
    }
  }
  return std::stoul(std::string{text.substr(star + 1, 2)}, nullptr, 16) == crc;
}

/// There is no checksum. A line has a head, fields without a second colon and a line end. A known
/// line also has the right number of fields.
bool sound_pd6(Bytes frame) {
  const std::string_view text = as_text(frame);
  if (text.size() < 5 || text[0] != ':' || text.rfind(':') != 0 || text[3] != ',') return false;
  if (!text.ends_with('\n')) return false;
  const auto fields = std::ranges::count(text, ',');
  const std::string_view name = text.substr(1, 2);
  if (name == "SA") return fields == 3;
  if (name == "TS") return fields == 6;
  if (name[0] != 'B' && name[0] != 'W') return true;
  if (name[1] == 'I' || name[1] == 'D') return fields == 5;
  return (name[1] != 'S' && name[1] != 'E') || fields == 4;
}

/// Sums of 16-bit words from B58C; an odd last byte is a high byte.
bool sound_ad2cp(Bytes frame) {
  const auto sum = [](Bytes bytes) {
    unsigned total = 0xB58C;
    for (std::size_t i = 0; i < bytes.size(); ++i)
      total += i % 2 == 1 || i + 1 == bytes.size() ? bytes[i] * 256u : bytes[i];
    return total % 65536;
  };
  const auto word = [&](std::size_t at) { return frame[at] + 256u * frame[at + 1]; };
  const std::size_t header = frame[1];
  return frame[0] == 0xA5 && (header == 10 || header == 12) &&
         word(header - 2) == sum(frame.first(header - 2)) &&
         word(header - 4) == sum(frame.subspan(header)) && frame.size() == header + word(4);
}

/// There is no checksum. Outside of texts the brackets match, and the last one ends the object.
bool sound_water_linked_json(Bytes frame) {
  std::string_view text = as_text(frame);
  while (text.ends_with('\n') || text.ends_with('\r')) text.remove_suffix(1);
  std::string open;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') ++i;
    if (c == '"') quoted = !quoted;
    if (quoted || (c != '{' && c != '[' && c != '}' && c != ']')) continue;
    if (i > 0 && open.empty()) return false;
    if (c == '{' || c == '[') {
      open += c;
    } else if (open.back() != (c == '}' ? '{' : '[')) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return text.starts_with('{') && text.ends_with('}') && open.empty() && !quoted;
}

template <class P>
bool sound(Bytes frame) {
  if constexpr (std::is_same_v<P, NortekAd2cp>) return sound_ad2cp(frame);
  if constexpr (std::is_same_v<P, Pd6>) return sound_pd6(frame);
  if constexpr (std::is_same_v<P, Nmea0183> || std::is_same_v<P, Nortek>)
    return sound_sentence(frame);
  if constexpr (std::is_same_v<P, Ubx>) return sound_ubx(frame);
  if constexpr (std::is_same_v<P, WaterLinked>) return sound_water_linked(frame);
  if constexpr (std::is_same_v<P, WaterLinkedJson>) return sound_water_linked_json(frame);
  if constexpr (std::is_same_v<P, UbxNmea>) {
    return frame[0] == '$' ? sound_sentence(frame) : sound_ubx(frame);
  }
  const std::size_t n = frame.size() - 2;
  const unsigned sum = std::accumulate(frame.begin(), frame.end() - 2, 0u);
  if (frame[n] + 256u * frame[n + 1] != sum % 65536) return false;
  if constexpr (std::is_same_v<P, Wayfinder>)
    return frame[0] == 0xAA && frame[3] + 256u * frame[4] == frame.size();
  if constexpr (std::is_same_v<P, Pd0>) return frame[0] == 0x7F && frame[1] == 0x7F;
  return frame[0] == 0x7D && frame[2] + 256u * frame[3] == n;
}

template <class P>
void expect_counters_add_up(const Reading<P>& reading, std::size_t bytes) {
  EXPECT_EQ(reading.counters.bytes_in, bytes);
  EXPECT_EQ(reading.counters.bytes_good + reading.counters.bytes_skipped + reading.held, bytes);
  EXPECT_EQ(reading.counters.frames, reading.frames.size());
}

/// Expects all golden frames in order. The stream gets enough quiet noise to end any wait for a
/// false length.
template <class P>
void expect_all_golden_frames_in(const Buffer& stream, const Buffer& golden) {
  const auto expected = read_stream<P>(golden).frames;
  const auto reading = read_stream<P>(stream + Buffer(P::max_frame, 0x00));
  for (const Buffer& frame : expected) {
    EXPECT_NE(std::ranges::find(reading.frames, frame), reading.frames.end()) << "frame lost";
  }
  expect_counters_add_up(reading, stream.size() + P::max_frame);
}

/// Random bytes and parts of real frames.
Buffer noise(const Buffer& golden) {
  const auto begin = *rc::gen::inRange<std::size_t>(0, golden.size());
  const auto end = *rc::gen::inRange<std::size_t>(begin, golden.size());
  const Buffer torn(golden.begin() + static_cast<long>(begin),
                    golden.begin() + static_cast<long>(end));
  return *rc::gen::arbitrary<Buffer>() + torn + *rc::gen::arbitrary<Buffer>();
}

template <class P>
class ByteProtocolTest : public ::testing::Test {};

template <class List>
struct AsTestTypes;
template <class... P>
struct AsTestTypes<ProtocolList<P...>> {
  using type = ::testing::Types<P...>;
};
TYPED_TEST_SUITE(ByteProtocolTest, typename AsTestTypes<BytesProtocols>::type);

TYPED_TEST(ByteProtocolTest, TakesEveryGoldenFrameAndNoByteMore) {
  const Buffer stream = Golden<TypeParam>::stream();
  const auto reading = read_stream<TypeParam>(stream);
  EXPECT_EQ(reading.frames.size(), Golden<TypeParam>::frames);
  EXPECT_EQ(reading.messages.size(), Golden<TypeParam>::messages);
  EXPECT_EQ(reading.counters.bytes_good, stream.size());
  EXPECT_EQ(reading.counters.bad_checksums, 0u);
}

TYPED_TEST(ByteProtocolTest, SeesTheSameInAnySplit) {
  const Buffer stream = Golden<TypeParam>::stream();
  const auto whole = read_stream<TypeParam>(stream);
  EXPECT_TRUE(holds([&] {
    const auto pieces = *rc::gen::nonEmpty(
        rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(1, 120)));
    const auto split = read_stream<TypeParam>(stream, pieces);
    RC_ASSERT(split.frames == whole.frames);
    RC_ASSERT(split.counters == whole.counters);
  }));
}

TYPED_TEST(ByteProtocolTest, SplitNoiseCountsLikeWholeNoise) {
  const Buffer golden = Golden<TypeParam>::stream();
  EXPECT_TRUE(holds([&] {
    const Buffer stream = noise(golden) + golden + noise(golden);
    const auto whole = read_stream<TypeParam>(stream);
    const auto bytewise = read_stream<TypeParam>(stream, {1});
    RC_ASSERT(bytewise.frames == whole.frames);
    RC_ASSERT(bytewise.counters == whole.counters);
  }));
}

TYPED_TEST(ByteProtocolTest, FindsEveryFrameBetweenNoise) {
  const Buffer golden = Golden<TypeParam>::stream();
  EXPECT_TRUE(holds([&] {
    const Buffer stream = noise(golden) + golden + noise(golden);
    expect_all_golden_frames_in<TypeParam>(stream, golden);
    RC_ASSERT(!::testing::Test::HasFailure());
  }));
}

TYPED_TEST(ByteProtocolTest, LosesNoFrameBehindAFalseSync) {
  const Buffer golden = Golden<TypeParam>::stream();
  const Buffer sync = Golden<TypeParam>::false_sync();
  for (std::size_t n = 1; n <= sync.size(); ++n) {
    const Buffer head(sync.begin(), sync.begin() + static_cast<long>(n));
    expect_all_golden_frames_in<TypeParam>(head + golden, golden);
  }
}

TYPED_TEST(ByteProtocolTest, LosesNoFrameBehindADamagedOne) {
  const Buffer golden = Golden<TypeParam>::stream();
  Buffer damaged = read_stream<TypeParam>(golden).frames.front();
  damaged[Golden<TypeParam>::inside] ^= 0x01;
  const auto reading = read_stream<TypeParam>(damaged + golden);
  EXPECT_EQ(reading.frames.size(), Golden<TypeParam>::frames);
  EXPECT_GE(reading.counters.bad_checksums, 1u);
  expect_counters_add_up(reading, damaged.size() + golden.size());
}

TYPED_TEST(ByteProtocolTest, LosesNoFrameBehindATruncatedOne) {
  const Buffer golden = Golden<TypeParam>::stream();
  const Buffer first = read_stream<TypeParam>(golden).frames.front();
  for (std::size_t n = 1; n < first.size(); ++n) {
    const Buffer cut(first.begin(), first.begin() + static_cast<long>(n));
    expect_all_golden_frames_in<TypeParam>(cut + golden, golden);
  }
}

TYPED_TEST(ByteProtocolTest, NoBytesMakeAFrameWithAWrongChecksum) {
  const Buffer golden = Golden<TypeParam>::stream();
  EXPECT_TRUE(holds([&] {
    Buffer stream = golden;
    const auto changes = *rc::gen::arbitrary<std::vector<std::pair<std::uint32_t, std::uint8_t>>>();
    for (const auto& [at, value] : changes) stream[at % stream.size()] = value;
    const auto reading = read_stream<TypeParam>(stream);
    for (const Buffer& frame : reading.frames) RC_ASSERT(sound<TypeParam>(frame));
    expect_counters_add_up(reading, stream.size());
  }));
}

TYPED_TEST(ByteProtocolTest, DecodesAnyFrameShapedBytesWithoutHarm) {
  const auto frames = read_stream<TypeParam>(Golden<TypeParam>::stream()).frames;
  EXPECT_TRUE(holds([&] {
    Buffer frame = *rc::gen::elementOf(frames);
    frame.resize(*rc::gen::inRange<std::size_t>(1, frame.size() + 1));
    const auto changes = *rc::gen::arbitrary<std::vector<std::pair<std::uint16_t, std::uint8_t>>>();
    for (const auto& [at, value] : changes) frame[at % frame.size()] = value;
    TypeParam::decode(frame);
  }));
}

TYPED_TEST(ByteProtocolTest, MessagesNameTheirFieldsOnce) {
  for (const auto& message : read_stream<TypeParam>(Golden<TypeParam>::stream()).messages) {
    std::vector<std::string> keys;
    std::visit(
        [&](const auto& m) {
          EXPECT_FALSE(m.type.empty());
          visit_fields(m, [&](std::string_view key, const auto&) { keys.emplace_back(key); });
        },
        message);
    std::ranges::sort(keys);
    EXPECT_EQ(std::ranges::adjacent_find(keys), keys.end());
  }
}

}  // namespace conformance_test
}  // namespace drydock::wire::testing

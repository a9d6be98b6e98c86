// Recordings that try to use all memory or all time of their reader.
#include <gtest/gtest.h>
#include <zstd.h>

#include <cstring>
#include <memory>
#include <sstream>

#include "drivers/recordings/mcap/encoder.hpp"
#include "drivers/recordings/record/message_layout.hpp"
#include "drivers/recordings/record/recording.hpp"

namespace drydock::record {
namespace hostile_recording_test {

struct Nothing {
  void value(const MessageNode&, std::size_t, mcap::Bytes) {}
  void begin(const MessageNode&, std::size_t) {}
  void end(const MessageNode&) {}
  void enter(const MessageNode&, std::size_t) {}
  void leave(const MessageNode&) {}
};

/// A definition in which each of `levels` messages contains ten of the next.
std::string ten_of_ten(int levels) {
  std::string text;
  for (int level = 0; level < levels; ++level) {
    if (level > 0) text += "===\nMSG: t/L" + std::to_string(level) + "\n";
    for (int i = 0; i < 10; ++i)
      text += (level + 1 < levels ? "t/L" + std::to_string(level + 1) : "uint8") + " f" +
              std::to_string(i) + "\n";
  }
  return text;
}

TEST(HostileDefinition, MessagesThatMultiplyAreNotUnderstood) {
  EXPECT_TRUE(parse_definition(ten_of_ten(3), "t/M"));
  EXPECT_FALSE(parse_definition(ten_of_ten(15), "t/M"));
}

TEST(HostileDefinition, OneThatHoldsItselfIsNotUnderstood) {
  EXPECT_FALSE(parse_definition("t/A a\n===\nMSG: t/A\nt/A a\n", "t/M"));
}

TEST(HostileDefinition, ElementsWithoutABytecannotBeCountedForEver) {
  EXPECT_FALSE(parse_definition("t/A[4000000000] a\n===\nMSG: t/A\nuint8[0] none\n", "t/M"));
  const std::vector<std::uint8_t> cdr{0, 1, 0, 0, 1, 2, 3};
  for (const char* endless :
       {"uint8[18446744073709551615] a\n", "t/A[18446744073709551615] a\n===\nMSG: t/A\n"}) {
    const auto layout = parse_definition(endless, "t/M");
    ASSERT_TRUE(layout) << endless;
    EXPECT_FALSE(visit_message(*layout, cdr, Nothing{})) << endless;
  }
}

/// What zstd makes of `head` and `size` zeros behind it, without holding them.
mcap::Buffer packed(const mcap::Buffer& head, std::size_t size) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> zstd(ZSTD_createCCtx(),
                                                                  &ZSTD_freeCCtx);
  ZSTD_CCtx_setPledgedSrcSize(zstd.get(), head.size() + size);
  mcap::Buffer bytes(100'000);
  ZSTD_outBuffer to{bytes.data(), bytes.size(), 0};
  const std::vector<std::uint8_t> zeros(1 << 16);
  ZSTD_inBuffer from{head.data(), head.size(), 0};
  while (from.pos < from.size) ZSTD_compressStream2(zstd.get(), &to, &from, ZSTD_e_continue);
  for (std::size_t rest = size; rest > 0; rest -= from.size) {
    from = {zeros.data(), std::min(rest, zeros.size()), 0};
    while (from.pos < from.size) ZSTD_compressStream2(zstd.get(), &to, &from, ZSTD_e_continue);
  }
  EXPECT_EQ(ZSTD_compressStream2(zstd.get(), &to, &from, ZSTD_e_end), 0U);
  bytes.resize(to.pos);
  return bytes;
}

/// A chunk that decompresses to one schema of `size` zeros.
mcap::Buffer packed_schema(std::uint16_t id, std::uint32_t size) {
  mcap::Buffer record;
  mcap::encode(record, mcap::Schema{id, "t", "ros2msg", {}});
  const auto set = [&](std::size_t at, auto number) {
    std::memcpy(&record[at], &number, sizeof number);
  };
  set(record.size() - 4, size);                     // little-endian, as this machine is
  set(1, std::uint64_t{record.size() - 9 + size});  // the length of what follows opcode and length
  const mcap::Buffer bytes = packed(record, size);
  mcap::Buffer chunk;
  mcap::Encoder(chunk).record(mcap::Opcode::chunk, [&] {
    mcap::Encoder(chunk)
        .number(std::uint64_t{0})
        .number(std::uint64_t{0})
        .number(std::uint64_t{record.size() + size})
        .number(std::uint32_t{0})
        .text("zstd")
        .sized<std::uint64_t>([&] { mcap::Encoder(chunk).raw(mcap::Bytes(bytes)); });
  });
  return chunk;
}

void append(mcap::Buffer& file, const mcap::Buffer& bytes) {
  file.insert(file.end(), bytes.begin(), bytes.end());
}

TEST(HostileRecording, ASmallFileCannotFillTheMemory) {
  mcap::Buffer file(mcap::magic.begin(), mcap::magic.end());
  mcap::encode(file, mcap::Header{"ros2", "x"});
  for (std::uint16_t id = 1; id <= 6; ++id) append(file, packed_schema(id, 60U << 20));
  EXPECT_LT(file.size(), 100'000U);
  const auto recording = Recording::open(
      std::make_unique<std::istringstream>(std::string(file.begin(), file.end())), "bomb.mcap");
  ASSERT_FALSE(recording);
  EXPECT_EQ(recording.error().line,
            "bomb.mcap: more than 256 MB of schemas, channels and attachments");
}

TEST(HostileRecording, WhatIsRepeatedInEveryChunkCountsOnce) {
  mcap::Buffer file(mcap::magic.begin(), mcap::magic.end());
  mcap::encode(file, mcap::Header{"ros2", "x"});
  const mcap::Buffer chunk = packed_schema(1, 60U << 20);
  for (int i = 0; i < 6; ++i) append(file, chunk);
  mcap::encode(file, mcap::Channel{1, 1, "/t", "cdr", {}});
  const auto recording = Recording::open(
      std::make_unique<std::istringstream>(std::string(file.begin(), file.end())), "dive.mcap");
  ASSERT_TRUE(recording);
}

}  // namespace hostile_recording_test
}  // namespace drydock::record

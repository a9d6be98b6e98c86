// Recordings that try to use all memory or all time of their reader.
#include <gtest/gtest.h>
#include <zstd.h>

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
  EXPECT_TRUE(parse_definition(ten_of_ten(3)));
  EXPECT_FALSE(parse_definition(ten_of_ten(15)));
}

TEST(HostileDefinition, OneThatHoldsItselfIsNotUnderstood) {
  EXPECT_FALSE(parse_definition("t/A a\n===\nMSG: t/A\nt/A a\n"));
}

TEST(HostileDefinition, ElementsWithoutABytecannotBeCountedForEver) {
  EXPECT_FALSE(parse_definition("t/A[18446744073709551615] a\n===\nMSG: t/A\n"));
  EXPECT_FALSE(parse_definition("t/A[4000000000] a\n===\nMSG: t/A\nuint8[0] none\n"));
  const auto layout = parse_definition("uint8[18446744073709551615] a\n");
  ASSERT_TRUE(layout);
  const std::vector<std::uint8_t> cdr{0, 1, 0, 0, 1, 2, 3};
  EXPECT_FALSE(visit_message(*layout, cdr, Nothing{}));
}

/// A chunk that decompresses to one schema of `size` zeros.
void append_packed_schema(mcap::Buffer& file, std::uint16_t id, std::size_t size) {
  mcap::Buffer records;
  mcap::encode(records, mcap::Schema{id, "t", "ros2msg", std::string(size, '\0')});
  mcap::Buffer packed(ZSTD_compressBound(records.size()));
  packed.resize(ZSTD_compress(packed.data(), packed.size(), records.data(), records.size(), 1));
  mcap::Encoder(file).record(mcap::Opcode::chunk, [&] {
    mcap::Encoder(file)
        .number(std::uint64_t{0})
        .number(std::uint64_t{0})
        .number(std::uint64_t{records.size()})
        .number(std::uint32_t{0})
        .text("zstd")
        .sized<std::uint64_t>([&] { mcap::Encoder(file).raw(mcap::Bytes(packed)); });
  });
}

TEST(HostileRecording, ASmallFileCannotFillTheMemory) {
  mcap::Buffer file(mcap::magic.begin(), mcap::magic.end());
  mcap::encode(file, mcap::Header{"ros2", "x"});
  for (std::uint16_t id = 1; id <= 6; ++id) append_packed_schema(file, id, 60u << 20);
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
  for (int chunk = 0; chunk < 6; ++chunk) append_packed_schema(file, 1, 60u << 20);
  mcap::encode(file, mcap::Channel{1, 1, "/t", "cdr", {}});
  const auto recording = Recording::open(
      std::make_unique<std::istringstream>(std::string(file.begin(), file.end())), "dive.mcap");
  ASSERT_TRUE(recording);
}

}  // namespace hostile_recording_test
}  // namespace drydock::record

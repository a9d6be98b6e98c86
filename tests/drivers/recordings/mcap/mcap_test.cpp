#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "drivers/recordings/mcap/encoder.hpp"
#include "drivers/recordings/mcap/file_sink.hpp"
#include "drivers/recordings/mcap/reader.hpp"
#include "drivers/recordings/mcap/writer.hpp"
#include "tests/drivers/recordings/mcap/read_back.hpp"

namespace drydock::mcap {
namespace mcap_test {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::uint64_t second = 1'000'000'000;
constexpr std::uint64_t start = 1'790'000'000 * second;

/// Writes two channels with ten messages a second each, for `seconds`.
void fill(Writer& writer, int seconds) {
  const std::string attached = "[rig]\n";
  writer.add(Attachment{start, start, "rig.toml", "application/toml", attached});
  writer.add(Metadata{"versions", {{"drydock", "0.1.0"}}});
  writer.add(Schema{1, "std_msgs/msg/UInt8", "ros2msg", "uint8 data\n"});
  writer.add(Channel{1, 1, "/a", "cdr", {{"link", "pty:a"}}});
  writer.add(Channel{2, 1, "/b", "cdr", {}});
  for (int i = 0; i < 10 * seconds; ++i) {
    const auto time = start + static_cast<std::uint64_t>(i) * second / 10;
    const std::array<std::uint8_t, 5> data{0, 1, 0, 0, static_cast<std::uint8_t>(i)};
    writer.add(Message{1, static_cast<std::uint32_t>(i), time, time, data});
    writer.add(Message{2, static_cast<std::uint32_t>(i), time + 1, time, data});
  }
}

/// A path in a folder of this test.
class McapFile : public testing::Test {
 protected:
  McapFile() {
    auto name = (std::filesystem::temp_directory_path() / "drydock-mcap-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    path_ = folder_ / "dive.mcap";
  }
  ~McapFile() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_, path_;
};

TEST_F(McapFile, IsReadByTheFormatsOwnReaderWithEveryChecksumChecked) {
  Writer writer(file_sink(path_).value(), {"ros2", "drydock"});
  fill(writer, 12);
  ASSERT_FALSE(writer.finish());
  EXPECT_EQ(writer.size(), std::filesystem::file_size(path_));

  DRYDOCK_NEEDS_NODE();
  auto found = mcap::test::read_back(path_);
  ASSERT_FALSE(found.contains("indexedError")) << found["indexedError"];
  const auto& file = found["indexed"];
  EXPECT_EQ(file["profile"], "ros2");
  EXPECT_EQ(file["statistics"]["messageCount"], "240");
  EXPECT_EQ(file["statistics"]["messageStartTime"], std::to_string(start));
  EXPECT_EQ(file["statistics"]["messageEndTime"], std::to_string(start + 119 * second / 10 + 1));
  EXPECT_EQ(file["statistics"]["chunkCount"], file["chunks"]);
  EXPECT_GE(file["chunks"], 10);  // one each second, or more
  EXPECT_EQ(file["topics"]["/a"]["count"], 120);
  EXPECT_EQ(file["topics"]["/b"]["count"], 120);
  EXPECT_EQ(file["topics"]["/a"]["metadata"]["link"], "pty:a");
  EXPECT_EQ(file["topics"]["/a"]["last"]["data"], 119);
  EXPECT_EQ(file["attachments"][0]["text"], "[rig]\n");
  EXPECT_EQ(file["metadata"][0]["values"]["drydock"], "0.1.0");
  EXPECT_TRUE(found["streamed"]["done"]);
}

// A recorder reuses its blocks in the order in which its thread returns them.
TEST(Block, HasTheSameIndexesWhateverChannelsItHeldBefore) {
  const std::array<std::uint8_t, 1> data{7};
  const auto channels_after = [&](std::vector<std::uint16_t> earlier) {
    Block block;
    for (const auto channel : earlier) block.add(Message{channel, 0, start, start, data});
    block.clear();
    for (const std::uint16_t channel : {2, 3, 1})
      block.add(Message{channel, 0, start, start, data});
    std::vector<std::uint16_t> channels;
    for (const auto& index : block.indexes())
      if (!index.entries.empty()) channels.push_back(index.channel);
    return channels;
  };
  EXPECT_THAT(channels_after({}), ElementsAre(1, 2, 3));
  EXPECT_THAT(channels_after({3, 4, 1}), ElementsAre(1, 2, 3));
}

/// Counts the records from a reader.
struct Tally {
  int schemas = 0, channels = 0, messages = 0, attachments = 0, metadata = 0;
  bool complete = false;
};

Tally read_all(Reader& reader) {
  Tally tally;
  while (const auto record = reader.next()) {
    if (std::holds_alternative<Schema>(*record)) ++tally.schemas;
    if (std::holds_alternative<Channel>(*record)) ++tally.channels;
    if (std::holds_alternative<Message>(*record)) ++tally.messages;
    if (std::holds_alternative<Attachment>(*record)) ++tally.attachments;
    if (std::holds_alternative<Metadata>(*record)) ++tally.metadata;
    tally.complete = std::holds_alternative<DataEnd>(*record);
  }
  return tally;
}

/// The bytes of a finished file, in memory.
std::string recorded(int seconds) {
  std::string bytes;
  Writer writer(
      [&](Bytes more) {
        bytes.append(more.begin(), more.end());
        return boost::system::error_code{};
      },
      {"ros2", "drydock"});
  fill(writer, seconds);
  EXPECT_FALSE(writer.finish());
  return bytes;
}

TEST(McapReader, FindsWhatWasWritten) {
  Reader reader(std::make_unique<std::istringstream>(recorded(3)));
  const Tally tally = read_all(reader);
  EXPECT_EQ(tally.schemas, 1);
  EXPECT_EQ(tally.channels, 2);
  EXPECT_EQ(tally.messages, 60);
  EXPECT_EQ(tally.attachments, 1);
  EXPECT_EQ(tally.metadata, 1);
  EXPECT_TRUE(tally.complete);
  EXPECT_EQ(reader.damage(), "");
}

TEST(McapReader, ReadsACutFileUpToTheLastWholeChunkWhereverTheCutIs) {
  const std::string whole = recorded(4);
  int before = 0;
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    Reader reader(std::make_unique<std::istringstream>(whole.substr(0, size)));
    const Tally tally = read_all(reader);
    EXPECT_GE(tally.messages, before) << size;
    before = tally.messages;
    EXPECT_TRUE(tally.complete || !reader.damage().empty()) << size;
    EXPECT_LE(reader.position(), size);
  }
  EXPECT_EQ(before, 80);
}

TEST(McapReader, NeverTakesAChangedByteForAnotherMessage) {
  const std::string whole = recorded(1);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string bytes = whole;
    bytes[i] = static_cast<char>(bytes[i] ^ 0x10);
    Reader reader(std::make_unique<std::istringstream>(bytes));
    while (const auto record = reader.next()) {
      const auto* message = std::get_if<Message>(&*record);
      if (message != nullptr) {
        ASSERT_EQ(message->data[4], message->sequence) << "byte " << i;
      }
    }
  }
}

/// Where the chunks of a file begin, as the records' own lengths tell it.
std::vector<std::size_t> chunks_of(const std::string& bytes) {
  std::vector<std::size_t> chunks;
  for (std::size_t at = magic.size(); at + record_head < bytes.size();) {
    std::uint64_t length = 0;
    std::memcpy(&length, bytes.data() + at + 1, sizeof length);
    if (bytes[at] == '\x06') chunks.push_back(at);
    at += record_head + length;
  }
  return chunks;
}

TEST(McapReader, ADamagedChunkCostsNoMoreThanItsOwnMessages) {
  const std::string whole = recorded(8);
  const auto chunks = chunks_of(whole);
  ASSERT_GE(chunks.size(), 7U);
  const std::size_t in_content = 60, length = 1, packed_length = record_head + 36;
  for (const std::size_t where : {in_content, length, length + 2, length + 7, packed_length})
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      std::string bytes = whole;
      bytes[chunks[i] + where] = static_cast<char>(bytes[chunks[i] + where] ^ 0x04);
      Reader reader(std::make_unique<std::istringstream>(bytes));
      const Tally tally = read_all(reader);
      // A chunk of one second holds 11 moments of two messages each; the last one the rest.
      EXPECT_GE(tally.messages, 160 - 22) << "byte " << where << " of chunk " << i;
      EXPECT_LE(tally.messages, 160);
      EXPECT_EQ(tally.attachments, 1);
      EXPECT_GE(tally.channels, 2) << "the summary names the channels of chunk " << i;
      if (i + 1 == chunks.size()) continue;  // nothing behind it tells its end
      EXPECT_TRUE(tally.complete);
      if (tally.messages < 160) {
        EXPECT_THAT(reader.damage(), HasSubstr(" B left out"));
      }
    }
}

TEST(McapReader, SaysHowMuchItLeftOutAndWhereTheFileIsCutToo) {
  std::string bytes = recorded(8);
  const auto chunks = chunks_of(bytes);
  for (const std::size_t i : {2U, 4U}) bytes[chunks[i] + 60] ^= 0x04;
  Reader reader(std::make_unique<std::istringstream>(bytes.substr(0, chunks.back() + 70)));
  read_all(reader);
  EXPECT_THAT(reader.damage(),
              testing::MatchesRegex(
                  "byte [0-9]+: a chunk's content is not what its checksum says; [0-9]+ B left out "
                  "in 2 places; byte [0-9]+: the file is cut here, inside a record"));
}

TEST(McapReader, SaysWhatIsWrongAndWhere) {
  const auto damage_of = [](std::string bytes) {
    Reader reader(std::make_unique<std::istringstream>(std::move(bytes)));
    read_all(reader);
    return reader.damage();
  };
  EXPECT_EQ(damage_of("hello, this is no recording"), "byte 0: not an MCAP file");
  EXPECT_EQ(damage_of(""), "byte 0: not an MCAP file");
  const std::string whole = recorded(1);
  EXPECT_THAT(damage_of(whole.substr(0, 40)), HasSubstr("the file is cut here"));
  std::string endless = whole.substr(0, 8);
  endless += '\x06' + std::string("\xff\xff\xff\xff\xff\xff\xff\x7f", 8);
  EXPECT_EQ(damage_of(endless), "byte 8: the file is cut here, inside a record");
}

TEST_F(McapFile, KeepsAFileThatIsThere) {
  ASSERT_TRUE(file_sink(path_).has_value());
  const auto second_time = file_sink(path_);
  ASSERT_TRUE(second_time.has_error());
  EXPECT_EQ(second_time.error(), boost::system::errc::file_exists);
  EXPECT_TRUE(file_sink(path_, true).has_value());
}

TEST_F(McapFile, AFileDeletedMeanwhileIsAnError) {
  Writer writer(file_sink(path_).value(), {"ros2", "drydock"});
  std::filesystem::remove_all(folder_);
  fill(writer, 1);
  EXPECT_EQ(writer.flush(), boost::system::errc::no_such_file_or_directory);
}

TEST_F(McapFile, AFullDiskIsAnErrorAndWhatWasWrittenBeforeReads) {
  // The limit of file size simulates a full disk: write() then gives EFBIG instead of ENOSPC.
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{2000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  Writer writer(file_sink(path_).value(), {"ros2", "drydock"});
  fill(writer, 20);
  const auto error = writer.finish();
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(error, boost::system::errc::file_too_large);
  Reader reader(std::make_unique<std::ifstream>(path_, std::ios::binary));
  EXPECT_GT(read_all(reader).messages, 20);
  EXPECT_NE(reader.damage(), "");
}

TEST(McapEncoder, ChecksumIsThatOfZlib) {
  const std::string check = "123456789";  // the check value of CRC-32/ISO-HDLC in the CRC catalogue
  EXPECT_EQ(crc32(Bytes{reinterpret_cast<const std::uint8_t*>(check.data()), check.size()}),
            0xCBF43926U);
}

}  // namespace mcap_test
}  // namespace drydock::mcap

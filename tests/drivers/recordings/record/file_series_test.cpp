#include "drivers/recordings/record/file_series.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "drivers/recordings/mcap/reader.hpp"
#include "drivers/recordings/record/part_files.hpp"

namespace drydock::record {
namespace file_series_test {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr std::uint64_t start = 1'700'000'000'000'000'000, second = 1'000'000'000;

/// What one file holds.
struct Content {
  std::vector<std::uint64_t> times;
  std::vector<std::string> channels, schemas, attachments;
  std::uint64_t lost = 0;
  std::string damage;
};

Content content_of(const fs::path& path) {
  mcap::Reader reader(std::make_unique<std::ifstream>(path, std::ios::binary));
  Content found;
  while (const auto record = reader.next()) {
    if (const auto* message = std::get_if<mcap::Message>(&*record))
      found.times.push_back(message->log_time);
    if (const auto* channel = std::get_if<mcap::Channel>(&*record))
      found.channels.push_back(channel->topic);
    if (const auto* schema = std::get_if<mcap::Schema>(&*record))
      found.schemas.push_back(schema->name);
    if (const auto* attachment = std::get_if<mcap::Attachment>(&*record))
      found.attachments.push_back(attachment->name);
    if (const auto* metadata = std::get_if<mcap::Metadata>(&*record);
        metadata != nullptr && metadata->name == "recording")
      found.lost = std::stoull(metadata->values.front().second);
  }
  found.damage = reader.damage();
  return found;
}

class FileSeriesTest : public testing::Test {
 protected:
  FileSeriesTest() {
    auto name = (fs::temp_directory_path() / "drydock-series-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~FileSeriesTest() override { fs::remove_all(folder_); }

  FileSeries series(Split split) {
    split.virtual_time = true;
    auto files = std::make_shared<PartFiles>(folder_ / "dive.mcap", mcap::Sync::never);
    auto first = files->next().value();
    FileSeries made({std::move(first), split, [files] { return files->next(); }},
                    {{"ros2", "test"},
                     {{0, 0, "rig.toml", "application/toml", "[rig]\n"}},
                     {{"versions", {{"drydock", "x"}}}}});
    mcap::Block channels;
    channels.add(mcap::Schema{1, "a/B", "ros2msg", "int32 x"});
    channels.add(mcap::Channel{1, 1, "/raw/serial/dvl", "cdr", {}});
    EXPECT_FALSE(made.write(channels, 0));
    return made;
  }
  /// One message at that second, of bytes that cannot be compressed much.
  static mcap::Block block_at(std::uint64_t s, std::size_t size = 10) {
    std::vector<std::uint8_t> data(size);
    std::uint32_t state = static_cast<std::uint32_t>(s) + 1;
    for (auto& byte : data)
      byte = static_cast<std::uint8_t>((state = state * 1664525 + 1013904223) >> 24);
    mcap::Block block;
    block.add(mcap::Message{1, 0, start + s * second, start + s * second, data});
    return block;
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_))
      names.push_back(entry.path().filename());
    std::ranges::sort(names);
    return names;
  }
  std::vector<Content> contents() const {
    std::vector<Content> all;
    for (const auto& name : files()) all.push_back(content_of(folder_ / name));
    return all;
  }

  fs::path folder_;
};

TEST_F(FileSeriesTest, AFileOfTenSecondsHoldsTenSecondsAndNothingIsLostBetween) {
  auto all = series({.every = 10s});
  for (std::uint64_t s = 0; s < 35; ++s) EXPECT_FALSE(all.write(block_at(s), s < 15 ? 0 : 7));
  EXPECT_FALSE(all.finish(9));
  const auto parts = contents();
  ASSERT_EQ(files(), (std::vector<std::string>{"dive-0001.mcap", "dive-0002.mcap", "dive-0003.mcap",
                                               "dive-0004.mcap"}));
  std::uint64_t next = 0;
  for (const auto& part : parts) {
    EXPECT_EQ(part.damage, "");
    EXPECT_EQ(part.times.size(), next < 30 ? 10U : 5U);
    for (const auto time : part.times) EXPECT_EQ(time, start + next++ * second);
    EXPECT_EQ(part.attachments, std::vector<std::string>{"rig.toml"});
    EXPECT_EQ(std::ranges::count(part.channels, "/raw/serial/dvl"), 1);
    EXPECT_EQ(std::ranges::count(part.schemas, "a/B"), 1);
  }
  EXPECT_EQ(next, 35U);
  EXPECT_EQ(parts[0].lost, 0U);
  EXPECT_EQ(parts[1].lost, 7U);
  EXPECT_EQ(parts[2].lost, 0U);
  EXPECT_EQ(parts[3].lost, 2U);
}

TEST_F(FileSeriesTest, NoFileIsLargerThanToldButForItsSummary) {
  constexpr std::uint64_t most = 100'000, summary = 4'000;
  auto all = series({.size = most});
  for (std::uint64_t s = 0; s < 60; ++s) EXPECT_FALSE(all.write(block_at(s, 10'000), 0));
  EXPECT_FALSE(all.finish(0));
  std::size_t messages = 0;
  for (const auto& name : files()) EXPECT_LT(fs::file_size(folder_ / name), most + summary);
  for (const auto& part : contents()) messages += part.times.size();
  EXPECT_EQ(messages, 60U);
  EXPECT_GE(files().size(), 6U);
  EXPECT_LE(files().size(), 8U);
}

TEST_F(FileSeriesTest, TheRingKeepsTheLastHoursAndOnlyForgetsItsOwnFiles) {
  const auto foreign = folder_ / "dive-0001.mcap";  // of a dive before
  std::ofstream(foreign) << "not ours";
  auto all = series({.every = 10s, .keep_for = 25s});
  for (std::uint64_t s = 0; s < 100; ++s) EXPECT_FALSE(all.write(block_at(s), 0));
  EXPECT_FALSE(all.finish(0));
  EXPECT_EQ(all.files(), 10U);
  EXPECT_EQ(all.deleted(), 7U);
  EXPECT_EQ(files(), (std::vector<std::string>{"dive-0001.mcap", "dive-0009.mcap", "dive-0010.mcap",
                                               "dive-0011.mcap"}));
  EXPECT_EQ(fs::file_size(foreign), 8U);
  EXPECT_EQ(content_of(folder_ / "dive-0009.mcap").times.front(), start + 70 * second);
}

TEST_F(FileSeriesTest, TheRingStaysWithinItsSize) {
  constexpr std::uint64_t most = 400'000, block = 11'000;
  auto all = series({.size = 100'000, .keep_size = most});
  std::uint64_t largest = 0;
  for (std::uint64_t s = 0; s < 200; ++s) {
    EXPECT_FALSE(all.write(block_at(s, 10'000), 0));
    std::uint64_t present = 0;
    for (const auto& name : files()) present += fs::file_size(folder_ / name);
    largest = std::max(largest, present);
  }
  EXPECT_LE(largest, most + block);
  EXPECT_GT(largest, most - 100'000 - block);
}

TEST_F(FileSeriesTest, AFileThatSomebodyPutInThePlaceOfOursStays) {
  auto all = series({.every = 10s, .keep_for = 25s});
  for (std::uint64_t s = 0; s < 30; ++s) EXPECT_FALSE(all.write(block_at(s), 0));
  fs::rename(folder_ / "dive-0001.mcap", folder_ / "saved.mcap");
  std::ofstream(folder_ / "dive-0001.mcap") << "not ours";
  for (std::uint64_t s = 30; s < 100; ++s) EXPECT_FALSE(all.write(block_at(s), 0));
  EXPECT_FALSE(all.finish(0));
  EXPECT_EQ(fs::file_size(folder_ / "dive-0001.mcap"), 8U);
  EXPECT_EQ(content_of(folder_ / "saved.mcap").times.size(), 10U);
}

TEST_F(FileSeriesTest, AFullDiskAtASplitIsToldAndEndsTheRecording) {
  const auto full = boost::system::errc::make_error_code(boost::system::errc::no_space_on_device);
  auto first = PartFiles(folder_ / "dive.mcap", mcap::Sync::never).next().value();
  FileSeries all({std::move(first),
                  {.every = 10s, .virtual_time = true},
                  [&]() -> boost::system::result<Part> { return full; }},
                 {});
  for (std::uint64_t s = 0; s < 10; ++s) EXPECT_FALSE(all.write(block_at(s), 0));
  EXPECT_EQ(all.write(block_at(10), 0), full);
  EXPECT_EQ(all.write(block_at(11), 0), full);
  EXPECT_EQ(all.finish(2), full);
  EXPECT_EQ(content_of(folder_ / "dive-0001.mcap").times.size(), 10U);
}

}  // namespace file_series_test
}  // namespace drydock::record

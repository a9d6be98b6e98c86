#include "drivers/recordings/record/background_file.hpp"

#include <gtest/gtest.h>

#include <future>
#include <sstream>

#include "drivers/recordings/mcap/reader.hpp"

namespace drydock::record {
namespace background_file_test {

/// A disk that accepts nothing until release(), then everything.
class Disk {
 public:
  mcap::Sink sink() {
    return [this](mcap::Bytes bytes) {
      if (opened_) released_.wait();
      opened_ = true;  // the header passes: it is written before the thread starts
      content_.append(bytes.begin(), bytes.end());
      return error_;
    };
  }
  void release() { promise_.set_value(); }
  void fail() {
    error_ = boost::system::errc::make_error_code(boost::system::errc::no_space_on_device);
  }
  const std::string& content() const { return content_; }

 private:
  std::promise<void> promise_;
  std::shared_future<void> released_ = promise_.get_future().share();
  bool opened_ = false;
  boost::system::error_code error_;
  std::string content_;
};

mcap::Block block_of_one(std::uint64_t time) {
  mcap::Block block;
  block.add(mcap::Message{1, 0, time, time, {}});
  return block;
}

TEST(BackgroundFile, NeverWaitsForAStalledDiskAndLosesNothingThatItTook) {
  Disk disk;
  BackgroundFile file(FileSeries(Parts{{disk.sink()}}, {}));
  std::size_t taken = 0;
  for (std::uint64_t i = 0; i < 3 * BackgroundFile::most_waiting; ++i) {
    auto block = block_of_one(i);
    if (file.put(block)) ++taken;
  }
  // One more than the limit: the thread is writing one block.
  EXPECT_GE(taken, BackgroundFile::most_waiting);
  EXPECT_LE(taken, BackgroundFile::most_waiting + 1);
  disk.release();
  EXPECT_FALSE(file.finish());
  mcap::Reader reader(std::make_unique<std::istringstream>(disk.content()));
  std::size_t messages = 0;
  while (const auto record = reader.next())
    if (std::holds_alternative<mcap::Message>(*record)) ++messages;
  EXPECT_EQ(messages, taken);
  EXPECT_EQ(reader.damage(), "");
}

TEST(BackgroundFile, SaysWhatTheDiskSaid) {
  Disk disk;
  disk.release();
  BackgroundFile file(FileSeries(Parts{{disk.sink()}}, {}));
  disk.fail();
  auto block = block_of_one(1);
  EXPECT_TRUE(file.put(block));
  EXPECT_EQ(file.finish(), boost::system::errc::no_space_on_device);
  EXPECT_EQ(file.progress().error, boost::system::errc::no_space_on_device);
  EXPECT_EQ(file.progress().lost, 1U);
}

TEST(BackgroundFile, WhoWaitsForRoomIsNotLeftWaitingWhenTheDiskFails) {
  Disk disk;
  BackgroundFile file(FileSeries(Parts{{disk.sink()}}, {}));
  disk.fail();
  auto producer = std::async(std::launch::async, [&] {
    for (std::uint64_t i = 0;; ++i) {
      auto block = block_of_one(i);
      if (!file.put_when_there_is_room(block)) return i;
    }
  });
  disk.release();
  EXPECT_LE(producer.get(), 2 * BackgroundFile::most_waiting);
}

/// The first file is whole when the disk becomes full.
TEST(BackgroundFile, TheFileThatFailedIsNamed) {
  Disk good, full;
  good.release();
  full.release();
  full.fail();
  Parts parts{{good.sink(), "y-0001.mcap"}, {}, [&]() -> boost::system::result<Part> {
                return Part{full.sink(), "y-0002.mcap"};
              }};
  parts.split.every = std::chrono::seconds{2};
  parts.split.virtual_time = true;
  BackgroundFile file(FileSeries(std::move(parts), {{"ros2", "test"}, {}, {}}));
  for (std::uint64_t s = 0; s < 4; ++s) {
    auto block = block_of_one(s * 1'000'000'000);
    file.put_when_there_is_room(block);
  }
  EXPECT_TRUE(file.finish());
  EXPECT_EQ(file.progress().failed_file, "y-0002.mcap");
}

}  // namespace background_file_test
}  // namespace drydock::record

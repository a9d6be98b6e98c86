// What a pulled plug leaves. This program's own fdatasync and fsync stand before those of libc.
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>

#include "drivers/recordings/record/recorder.hpp"

namespace durable_test {

std::atomic<std::uint64_t> bytes_on_disk = 0, folders_on_disk = 0, folder_inode = 0;
std::atomic<int> syncs_of_this_thread = 0;
std::atomic<std::thread::id> drivers_thread;
std::atomic<bool> begun = false;  ///< the drivers run; before, a sync delays nothing

struct stat status_of(int file) {
  struct stat status {};
  ::fstat(file, &status);
  return status;
}

}  // namespace durable_test

extern "C" int fdatasync(int file) {
  using namespace durable_test;
  bytes_on_disk = static_cast<std::uint64_t>(status_of(file).st_size);
  if (begun && std::this_thread::get_id() == drivers_thread.load()) ++syncs_of_this_thread;
  return static_cast<int>(::syscall(SYS_fdatasync, file));
}

extern "C" int fsync(int file) {
  using namespace durable_test;
  const auto status = status_of(file);
  if (S_ISDIR(status.st_mode)) {
    ++folders_on_disk;
    folder_inode = status.st_ino;
  }
  return static_cast<int>(::syscall(SYS_fsync, file));
}

namespace durable_test {

using namespace drydock;
using measurement::Stamp;

constexpr Stamp start = measurement::stamp_from_ns(1'700'000'000'000'000'000);

/// A recording of one line that gets a byte each 100 ms for three seconds.
struct Dive {
  explicit Dive(mcap::Sync sync) {
    auto name = (std::filesystem::temp_directory_path() / "drydock-plug-XXXXXX").string();
    folder = mkdtemp(name.data());
    bytes_on_disk = folders_on_disk = 0;
    syncs_of_this_thread = 0;
    begun = false;
    drivers_thread = std::this_thread::get_id();
    record::RecorderOptions options;
    options.links = {{"pty:dvl?baud=115200", "dvl", false, {"dvl"}}};
    recorder.emplace(mcap::file_sink(folder / "dive.mcap", false, sync).value(), options);
    begun = true;
    const std::array<std::uint8_t, 1> byte{7};
    for (int ms = 0; ms < 3000; ms += 100)
      recorder->on_bytes("pty:dvl?baud=115200", shell::Direction::received, byte,
                         start + std::chrono::milliseconds{ms});
    recorder->tick(start + std::chrono::seconds{4});
  }
  ~Dive() { std::filesystem::remove_all(folder); }

  /// False after 10 s.
  bool written(std::uint64_t messages) const {
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds{10};
    while (recorder->status().messages < messages)
      if (std::chrono::steady_clock::now() > patience) return false;
    return true;
  }

  std::filesystem::path folder;
  std::optional<record::Recorder> recorder;
};

TEST(Durable, WhatIsCountedAsRecordedIsOnTheDiskAndItsNameIsToo) {
  const Dive dive(mcap::Sync::each_write);
  ASSERT_TRUE(dive.written(30));
  EXPECT_EQ(bytes_on_disk, dive.recorder->status().bytes);
  EXPECT_EQ(bytes_on_disk, std::filesystem::file_size(dive.folder / "dive.mcap"));
  EXPECT_EQ(folders_on_disk, 1U);
  struct stat folder {};
  ::stat(dive.folder.c_str(), &folder);
  EXPECT_EQ(folder_inode, folder.st_ino);
}

TEST(Durable, TheThreadOfTheDriversWaitsForNoDisk) {
  const Dive dive(mcap::Sync::each_write);
  ASSERT_TRUE(dive.written(30));
  EXPECT_EQ(syncs_of_this_thread, 0);
}

TEST(Durable, ARunInVirtualTimeWaitsForNoDiskEither) {
  const Dive dive(mcap::Sync::never);
  ASSERT_TRUE(dive.written(30));
  EXPECT_EQ(bytes_on_disk, 0U);
}

/// /dev/full stands for a disk that can take no more, /dev/null for what has nothing to sync.
TEST(Durable, APlaceWithoutADiskIsNoError) {
  const auto nowhere = mcap::file_sink("/dev/null", true, mcap::Sync::each_write).value();
  const std::array<std::uint8_t, 1> byte{7};
  EXPECT_FALSE(nowhere(byte));
  const auto full = mcap::file_sink("/dev/full", true, mcap::Sync::each_write).value();
  EXPECT_EQ(full(byte), boost::system::errc::no_space_on_device);
}

}  // namespace durable_test

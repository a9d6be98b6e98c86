#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "drivers/recordings/record/file_series.hpp"

namespace drydock::record {

/// Compresses and writes in its own thread, so that a slow disk never delays a driver.
class BackgroundFile {
 public:
  /// Limit of waiting blocks: 16 s at one block a second.
  static constexpr std::size_t most_waiting = 16;

  explicit BackgroundFile(FileSeries file);
  /// Without finish() the file has no summary, as after a crash.
  ~BackgroundFile();

  /// Takes the block and leaves an empty one in its place. False if too many wait or the file
  /// failed; the block is then unchanged, and its messages are counted as lost.
  bool put(mcap::Block& block);
  /// Waits for room. False if the file failed.
  bool put_when_there_is_room(mcap::Block& block);

  /// Writes all waiting blocks, then the number of lost messages and the summary. Nothing can be
  /// put afterwards.
  boost::system::error_code finish();

  struct Progress {
    boost::system::error_code error;
    std::uint64_t size = 0;                ///< bytes written
    std::uint64_t messages = 0, lost = 0;  ///< written; not taken or discarded
    std::uint64_t files = 1, deleted = 0;  ///< of a divided recording: made; deleted again
    std::string failed_file{};             ///< that the error is of; empty without one
  };
  Progress progress() const;

 private:
  void work();
  void note(const boost::system::error_code& error);
  bool take(mcap::Block& block);

  FileSeries file_;  ///< the thread owns it until the thread has ended
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<mcap::Block> waiting_, empty_;
  bool ended_ = false;
  Progress progress_;
  std::thread thread_;
};

}  // namespace drydock::record

#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "drivers/recordings/mcap/file_writer.hpp"

namespace drydock::record {

/// Compresses and writes in its own thread, so that a slow disk never delays a driver.
class BackgroundFile {
 public:
  /// Limit of waiting blocks: 16 s at one block a second.
  static constexpr std::size_t most_waiting = 16;

  explicit BackgroundFile(mcap::FileWriter file);
  /// Without finish() the file has no summary, as after a crash.
  ~BackgroundFile();

  /// Takes the block and leaves an empty one in its place. False if too many wait or the file
  /// failed; the block is then unchanged.
  bool put(mcap::Block& block);
  /// Waits for room. False if the file failed.
  bool put_when_there_is_room(mcap::Block& block);

  /// Writes all waiting blocks, then `last`, then the summary. Nothing can be put afterwards.
  boost::system::error_code finish(const mcap::Metadata& last);

  struct Progress {
    boost::system::error_code error;
    std::uint64_t size = 0;                ///< bytes in the file
    std::uint64_t messages = 0, lost = 0;  ///< in the blocks taken: written, discarded
  };
  Progress progress() const;

 private:
  void work();
  bool take(mcap::Block& block);

  mcap::FileWriter file_;  ///< the thread owns it until the thread has ended
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<mcap::Block> waiting_, empty_;
  bool ended_ = false;
  Progress progress_;
  std::thread thread_;
};

}  // namespace drydock::record

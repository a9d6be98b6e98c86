#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "drivers/recordings/mcap/file_writer.hpp"

namespace drydock::record {

/// Compresses and writes in a thread of its own, so that a slow disk never holds up a driver.
class BackgroundFile {
 public:
  /// As many blocks may wait: 16 s at a block a second.
  static constexpr std::size_t most_waiting = 16;

  explicit BackgroundFile(mcap::FileWriter file);
  /// Without finish(): the file has no summary, as after a crash.
  ~BackgroundFile();

  /// Takes the block and leaves an empty one. False: too many wait, or the file failed; the block
  /// is as it was.
  bool put(mcap::Block& block);
  /// Waits for room; false: the file failed.
  bool put_when_there_is_room(mcap::Block& block);

  /// Everything that waits is written, then `last`, then the summary. Nothing can be put later.
  boost::system::error_code finish(const mcap::Metadata& last);

  struct Progress {
    boost::system::error_code error;
    std::uint64_t size = 0;                ///< bytes in the file
    std::uint64_t messages = 0, lost = 0;  ///< of the blocks taken: written, given up
  };
  Progress progress() const;

 private:
  void work();
  bool take(mcap::Block& block);

  mcap::FileWriter file_;  ///< of the thread, until it has ended
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<mcap::Block> waiting_, empty_;
  bool ended_ = false;
  Progress progress_;
  std::thread thread_;
};

}  // namespace drydock::record

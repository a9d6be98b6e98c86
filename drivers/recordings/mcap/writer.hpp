#pragma once

#include <chrono>

#include "drivers/recordings/mcap/file_writer.hpp"

namespace drydock::mcap {

/// A block is full when it has this much content, or this much time between its first and last
/// message.
inline constexpr std::size_t block_size = 768 * 1024;
inline constexpr std::chrono::nanoseconds block_time = std::chrono::seconds{1};

inline bool is_full(const Block& block) {
  return block.records().size() >= block_size ||
         block.last_time() - block.first_time() >= static_cast<std::uint64_t>(block_time.count());
}

/// Writes a file in one thread, for tools: cut, recover, tests.
class Writer {
 public:
  Writer(Sink sink, const Header& header) : file_(std::move(sink), header) {}

  void add(const Schema& schema) { block_.add(schema); }
  void add(const Channel& channel) { block_.add(channel); }
  boost::system::error_code add(const Message& message) {
    block_.add(message);
    return is_full(block_) ? flush() : file_.error();
  }
  boost::system::error_code add(const Attachment& attachment) { return file_.write(attachment); }
  boost::system::error_code add(const Metadata& metadata) { return file_.write(metadata); }

  boost::system::error_code flush() {
    file_.write(block_);
    block_.clear();
    return file_.error();
  }
  boost::system::error_code finish() {
    flush();
    return file_.finish();
  }
  std::uint64_t size() const { return file_.size(); }

 private:
  FileWriter file_;
  Block block_;
};

}  // namespace drydock::mcap

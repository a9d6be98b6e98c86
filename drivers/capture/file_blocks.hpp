#pragma once

#include <functional>
#include <string>
#include <vector>

#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// Reads a file, pipe or standard input as blocks of bytes. It holds at most one block at a time.
class FileBlocks {
 public:
  explicit FileBlocks(const std::string& file);  ///< empty or "-": standard input
  ~FileBlocks();
  FileBlocks(const FileBlocks&) = delete;
  FileBlocks& operator=(const FileBlocks&) = delete;

  /// From now on `ended` may end the file before its end: it is asked before each block, and four
  /// times a second while a live input says nothing.
  void end_when(std::function<bool()> ended) { ended_ = std::move(ended); }

  /// The next bytes. Empty at the end or after an error.
  wire::Bytes read();
  /// True if the last read filled the block: more data are probably waiting.
  bool likely_more(wire::Bytes last) const { return last.size() == block_.size(); }
  int error() const { return error_; }  ///< errno; 0: none

 private:
  bool has_more() const;

  bool owned_;
  int fd_;
  int error_ = 0;
  std::vector<std::uint8_t> block_;
  std::function<bool()> ended_ = [] { return false; };
};

}  // namespace drydock::capture

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// Reads a file, pipe or standard input as blocks of bytes, or several, one behind the other. It
/// holds at most one block at a time.
class FileBlocks {
 public:
  explicit FileBlocks(const std::string& file);  ///< empty or "-": standard input
  /// None: standard input. A file is opened when the one before has ended.
  explicit FileBlocks(std::vector<std::string> files);
  ~FileBlocks() { close(); }
  FileBlocks(const FileBlocks&) = delete;
  FileBlocks& operator=(const FileBlocks&) = delete;

  /// From now on `ended` may end the file before its end: it is asked before each block, and four
  /// times a second while a live input says nothing.
  void end_when(std::function<bool()> ended) { ended_ = std::move(ended); }

  /// The next bytes. Empty at the end of the last file or after an error.
  wire::Bytes read();
  /// True if the last read gave the first bytes of a file behind the first one.
  bool is_next_file() const { return is_next_file_; }
  /// True if the last read filled the block: more data are probably waiting.
  bool likely_more(wire::Bytes last) const { return last.size() == block_.size(); }
  int error() const { return error_; }                       ///< errno; 0: none
  const std::string& file() const { return files_[file_]; }  ///< that was read last

 private:
  bool has_more() const;
  void open();
  void close();

  std::vector<std::string> files_;
  std::size_t file_ = 0;
  bool owned_ = false, is_next_file_ = false, begins_ = false;
  int fd_ = -1;
  int error_ = 0;
  std::vector<std::uint8_t> block_;
  std::function<bool()> ended_ = [] { return false; };
};

}  // namespace drydock::capture

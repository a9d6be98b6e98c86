#pragma once

#include <cstdint>
#include <vector>

#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// Removes the comments from the head of a byte capture; gpsd's test logs have them. A comment is a
/// line that begins with '#' and a blank, or that is '#' alone, or PuTTY's line above a log. Any
/// other line is data, as
/// `#BESTPOSA,...` of a device is, and so is all behind it. Numbers behind the '#' are data too
/// (`# 12.3456, 3.4`, as sensors of Sea-Bird answer). Feed the blocks of the capture in order.
class CommentHead {
 public:
  /// The part of the block behind the comments. The begin of a line that may be either comes with
  /// the next block.
  wire::Bytes without(wire::Bytes block);
  std::size_t size() const { return size_; }  ///< bytes of the comments so far

 private:
  enum class At : std::uint8_t { line_start, comment, data };
  At at_ = At::line_start;
  std::size_t size_ = 0;
  std::vector<std::uint8_t> held_;    ///< the begin of a line that may be either
  std::vector<std::uint8_t> joined_;  ///< what was held, and a block
};

}  // namespace drydock::capture

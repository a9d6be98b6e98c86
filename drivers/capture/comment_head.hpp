#pragma once

#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// Removes the lines that begin with '#' from the head of a byte capture; gpsd's test logs have
/// them. A '#' behind the head is data. Feed the blocks of the capture in order.
class CommentHead {
 public:
  /// The part of the block behind the comments.
  wire::Bytes without(wire::Bytes block);

 private:
  enum class At : std::uint8_t { line_start, comment, data };
  At at_ = At::line_start;
};

}  // namespace drydock::capture

#pragma once

#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// Drops the lines of a byte capture's head that begin with '#', as gpsd's test logs have them; a
/// '#' further on is data. Feed the capture's blocks in order.
class CommentHead {
 public:
  /// The rest of the block, behind the comments.
  wire::Bytes without(wire::Bytes block);

 private:
  enum class At : std::uint8_t { line_start, comment, data };
  At at_ = At::line_start;
};

}  // namespace drydock::capture

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/capture/comment_head.hpp"

namespace drydock::capture {

/// The bytes of a line in the blocks of a capture: without the comments of the head, and for a log
/// of hexadecimal text (a DVL's ASCII output: 7F7F and digits alone) the bytes that the digits
/// mean. Feed the blocks in order.
class ByteContent {
 public:
  /// `raw`: the capture to the byte.
  explicit ByteContent(bool raw) : raw_(raw) {}

  /// Valid until the next call.
  wire::Bytes of(wire::Bytes block);
  bool is_hex() const { return is_hex_.value_or(false); }

 private:
  wire::Bytes decoded(wire::Bytes digits);

  bool raw_;
  CommentHead head_;
  std::optional<bool> is_hex_;  ///< the first bytes behind the head decide it
  std::optional<std::uint8_t> half_;
  std::vector<std::uint8_t> bytes_;
};

/// True if the text is nothing but hexadecimal digits in lines, with the begin of a PD0 ensemble.
bool is_hex_text(wire::Bytes text);

}  // namespace drydock::capture

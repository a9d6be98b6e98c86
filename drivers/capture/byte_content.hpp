#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/capture/comment_head.hpp"
#include "drivers/capture/sentence_stamps.hpp"

namespace drydock::capture {

/// The bytes of a line in the blocks of a capture: without the comments of the head, and for a log
/// of hexadecimal text (a DVL's ASCII output: 7F7F and digits alone) the bytes that the digits
/// mean; for a logger's lines the sentences without its stamps. Feed the blocks in order.
class ByteContent {
 public:
  /// `raw`: the capture to the byte.
  explicit ByteContent(bool raw) : raw_(raw) {}

  /// Valid until the next call.
  wire::Bytes of(wire::Bytes block);
  /// The lines of the last block that have a time; `through` counts in what of() returned.
  std::span<const SentenceStamps::Timed> times() const;
  const SentenceStamps& stamps() const { return stamps_; }
  /// What a person must know of how the capture is read; empty: byte for byte.
  std::string note() const;

 private:
  bool is_hex() const { return is_hex_.value_or(false); }
  wire::Bytes decoded(wire::Bytes digits);

  bool raw_;
  CommentHead head_;
  SentenceStamps stamps_;
  std::optional<bool> is_hex_;  ///< the first bytes behind the head decide it
  std::optional<std::uint8_t> half_;
  std::vector<std::uint8_t> bytes_;
};

/// True if the text is nothing but hexadecimal digits in lines, with the begin of a PD0 ensemble.
bool is_hex_text(wire::Bytes text);

}  // namespace drydock::capture

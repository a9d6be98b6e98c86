#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/capture/comment_head.hpp"
#include "drivers/capture/hex_dump.hpp"
#include "drivers/capture/json_documents.hpp"
#include "drivers/capture/sentence_stamps.hpp"
#include "drivers/capture/stamped_hex.hpp"
#include "drivers/capture/utf16_text.hpp"

namespace drydock::capture {

/// The bytes of a line in the blocks of a capture: without the comments of the head, and for a log
/// of hexadecimal text (a DVL's ASCII output: 7F7F and digits alone) the bytes that the digits
/// mean, as for a dump with places, or with a logger's times in front; for JSON in a list or over
/// several lines an object a line; for a logger's lines the sentences without its stamps. A text of
/// 16 bits a letter is read as one of 8. Feed the blocks in order.
class ByteContent {
 public:
  /// `raw`: the capture to the byte.
  explicit ByteContent(bool raw) : raw_(raw) {}

  /// Valid until the next call.
  wire::Bytes of(wire::Bytes block);
  /// What is left at the end of the file; valid until the next call.
  wire::Bytes finish();
  /// True if a file that begins so, behind the one that was fed, is of another form or has a head
  /// of its own. Any other goes on where that one was cut.
  bool begins_anew(wire::Bytes head) const;
  /// The lines of the last block that have a time; `through` counts in what of() returned.
  std::span<const SentenceStamps::Timed> times() const;
  /// Of those times.
  const StampClock& clock() const {
    return form_ == Form::stamped_hex ? stamped_hex_.clock() : stamps_.clock();
  }
  /// What a person must know of how the capture is read; empty: byte for byte.
  std::string note() const;

 private:
  enum class Form : std::uint8_t { undecided, lines, hex, stamped_hex, dump, json };

  static Form form_of(wire::Bytes text);
  bool is_other(Form form, wire::Bytes text) const;
  std::string note_of_stamps() const;
  wire::Bytes decoded(wire::Bytes digits);

  bool raw_;
  std::optional<Utf16Text> utf16_;
  bool begun_ = false;
  CommentHead head_;
  SentenceStamps stamps_;
  JsonDocuments json_;
  HexDump dump_;
  StampedHex stamped_hex_;
  Form form_ = Form::undecided;  ///< the first bytes behind the head decide it
  std::optional<std::uint8_t> half_;
  std::vector<std::uint8_t> bytes_;
};

/// True if the text is nothing but hexadecimal digits in lines, with the begin of a PD0 ensemble.
bool is_hex_text(wire::Bytes text);

/// True if the text is nothing but bytes of two hexadecimal digits with blanks between, and has a
/// letter: others are numbers of something else.
bool is_hex_pairs(wire::Bytes text);

}  // namespace drydock::capture

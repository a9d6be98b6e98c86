#pragma once

#include <string_view>

#include "drivers/capture/record.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::capture {

using wire::Bytes;
using wire::Scan;

/// Reads one capture from its first byte on and keeps the content of its head. Sans-I/O:
/// FrameCapture gives it the bytes.
class Reader {
 public:
  virtual ~Reader() = default;
  /// Classifies the first bytes: a line or block, need more, skip n. At the end of the file
  /// (`at_end`) "need more" means that the last line or block is incomplete.
  virtual Scan scan(Bytes bytes, bool at_end) = 0;
  virtual Reading read(Bytes unit) = 0;
  /// More frames of the unit that was read last, for formats that put several frames into one unit.
  virtual std::optional<Record> more() { return std::nullopt; }
  /// What it decides by lines to come it decides now by these: what follows is of another file.
  virtual void settle(Bytes) {}
  /// True where more of a block is awaited that is passed over: at the end the file is cut inside.
  virtual bool is_inside_block() const { return false; }
  /// What a person must know of how it reads this file; empty: nothing.
  virtual std::string_view note() const { return {}; }
};

/// A text format: lines ended by LF, CR or CR LF.
class LineReader : public Reader {
 public:
  static constexpr std::size_t longest_line = 8192;  ///< canboat: 1785 bytes in hexadecimal

  Scan scan(Bytes bytes, bool at_end) override;
  Reading read(Bytes unit) final;

 protected:
  /// `line` is what text_of() gives, and not empty.
  virtual Reading read_line(std::string_view line) = 0;
};

/// The first line with its end. Every text format uses this rule. A line that is longer than in any
/// known format is skipped in parts.
Scan scan_line(Bytes bytes, bool at_end);

/// The line without its end, the blanks around it, and the mark with which some editors begin a
/// file of UTF-8.
std::string_view text_of(Bytes line);

}  // namespace drydock::capture

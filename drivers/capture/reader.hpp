#pragma once

#include <string_view>

#include "drivers/capture/record.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::capture {

using wire::Bytes;
using wire::Scan;

/// Reads one capture from its first byte on, keeping what its head said. Sans-I/O: FrameCapture
/// brings the bytes.
class Reader {
 public:
  virtual ~Reader() = default;
  /// What stands at the front: a line or block, need more, skip n. At the end of the file
  /// (`at_end`) "need more" means that the last one is cut short.
  virtual Scan scan(Bytes bytes, bool at_end) = 0;
  virtual Reading read(Bytes unit) = 0;
  /// Further frames of the unit last read, where a format packs several into one.
  virtual std::optional<Record> more() { return std::nullopt; }
};

/// A text format: lines ended by LF, CR or CR LF.
class LineReader : public Reader {
 public:
  static constexpr std::size_t longest_line = 2048;

  Scan scan(Bytes bytes, bool at_end) final;
  Reading read(Bytes unit) final;

 protected:
  /// `line` is without its end, and not empty.
  virtual Reading read_line(std::string_view line) = 0;
};

/// The line at the front with its end; the same rule for every text format. A line that is longer
/// than any of ours is skipped in parts.
Scan scan_line(Bytes bytes, bool at_end);

/// Without the end of line.
std::string_view text_of(Bytes line);

}  // namespace drydock::capture

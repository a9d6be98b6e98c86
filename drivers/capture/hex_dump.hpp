#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// The bytes of a dump in lines: a place, a colon or none, hexadecimal digits, and often the same
/// as letters, as xxd, `hexdump -C` and `od -t x1` print them. Places are hexadecimal, or octal
/// (od). A line `*` says that the bytes of the one before go on. Feed the blocks in order.
class HexDump {
 public:
  /// True if the first two lines have places that the bytes of the first one tell.
  static bool recognises(wire::Bytes text);
  /// True if the second line of the text is one of a dump: the first one may be cut.
  static bool goes_on(wire::Bytes text);

  /// Valid until the next call.
  wire::Bytes of(wire::Bytes block);
  wire::Bytes finish();  ///< of a last line without an end, once; valid until the next call
  /// Left out: they are none, or repeat too much.
  std::uint64_t odd_lines() const { return odd_lines_; }

  struct Line {
    std::string_view place;
    std::vector<std::uint8_t> bytes;
  };
  /// Empty: it is no line of a dump.
  static std::optional<Line> line_of(std::string_view text);

 private:
  void take(std::string_view line);
  void repeat_until(std::uint64_t place);

  std::string waiting_;  ///< of a line that is not whole
  std::vector<std::uint8_t> bytes_, last_;
  std::uint64_t next_ = 0;  ///< the place behind the last line
  int base_ = 0;            ///< of the places; 0: the second line tells it
  bool repeats_ = false;
  std::uint64_t may_repeat_ = 0;  ///< bytes, in the present block
  std::uint64_t odd_lines_ = 0;
};

}  // namespace drydock::capture

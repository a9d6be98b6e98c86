#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// Bytes of pairs of digits, at most so many. xxd has its letters behind two blanks; others behind
/// `|`, three blanks, or two and no digits, and two blanks after eight bytes. Empty: other letters
/// stand among them.
std::optional<std::vector<std::uint8_t>> pairs_of_dump(std::string_view text, bool of_xxd,
                                                       std::size_t most);

/// The bytes of a dump in lines: a place, a colon or none, hexadecimal digits, and often the same
/// as letters, as xxd, `hexdump -C`, `od -t x1` and Wireshark's windows of a stream print them.
/// Places are hexadecimal, or octal (od). A line `*` says that the bytes of the one before go on.
/// Of a stream, lines with another indentation than the first one are those of the other side. Feed
/// the blocks in order.
class HexDump {
 public:
  static constexpr std::size_t any_width = 1024;  ///< bytes a line

  /// True if the first two lines behind a short head have places that the bytes of the first one
  /// tell.
  static bool recognises(wire::Bytes text) { return layout_of(text).has_value(); }
  /// True if the second line of the text is one of a dump: the first one may be cut.
  static bool goes_on(wire::Bytes text);

  /// The first block of the text: it tells what stands in front of the lines and behind them.
  void begin(wire::Bytes head);
  /// Valid until the next call.
  wire::Bytes of(wire::Bytes block);
  wire::Bytes finish();  ///< of a last line without an end, once; valid until the next call
  /// Left out: they are none, or repeat too much.
  std::uint64_t odd_lines() const { return odd_lines_; }
  std::uint64_t lines_of_others() const { return others_; }  ///< left out: of the other side

 private:
  struct Line {
    std::size_t indent = 0;
    std::string_view place;
    std::vector<std::uint8_t> bytes;
  };
  struct Layout {
    std::size_t indent = 0, width = any_width;  ///< bytes a line at most
  };
  /// Empty: it is no line of a dump. `most`: bytes; what stands behind them are letters.
  static std::optional<Line> line_of(std::string_view text, std::size_t most);
  static std::optional<Layout> layout_of(wire::Bytes text);
  void take(std::string_view line);
  void repeat_until(std::uint64_t place);

  Layout layout_;
  std::string waiting_;  ///< of a line that is not whole
  std::vector<std::uint8_t> bytes_, last_;
  std::uint64_t next_ = 0;  ///< the place behind the last line
  int base_ = 0;            ///< of the places; 0: the second line tells it
  bool repeats_ = false;
  std::uint64_t may_repeat_ = 0;  ///< bytes, in the present block
  std::uint64_t odd_lines_ = 0, others_ = 0;
};

}  // namespace drydock::capture

#pragma once

#include <chrono>
#include <string>

#include "drivers/capture/reader.hpp"
#include "drivers/capture/words.hpp"

namespace drydock::capture {

/// Vector's ASCII log (.asc):
///    base hex  timestamps absolute
///       3.098426 1  18EBFF00x       Rx   d 8 01 A0 0F A6 60 3B D1 40    Length = ...
///      30.005021 CANFD   1 Rx  300   1 0 8  8 11 c2 03 04 05 06 07 08   102203  133   303000 ...
///       2.501000 1 ErrorFrame
/// The head gives the base of identifiers and data (hex or dec). It also says whether a time counts
/// from the start or from the previous line. Channel n is interface can(n-1), as in can-utils'
/// asc2log. The head's date is that of the start, unless the first trigger block is older: a
/// trigger cannot be before it, and a converter (python-can) writes its own time there. Lines of
/// statistics, bus states and transport protocols contain no frame.
class VectorAsc final : public LineReader {
 public:
  static constexpr std::string_view name = "asc";
  static bool recognises(std::string_view line);

  std::string_view note() const override { return note_; }

 private:
  Reading read_line(std::string_view line) override;
  bool read_head(std::string_view line);
  void read_trigger(Words words);
  Reading classic(std::string_view channel, Words words);
  Reading fast(Words words);
  bool read_identifier(std::string_view word, wire::CanFrame& frame) const;
  Reading in_channel(std::string_view channel, const wire::CanFrame& frame);

  int base_ = 16;
  bool relative_ = false;
  std::string_view note_;
  std::chrono::nanoseconds start_{};  ///< date of the start, since 1970
  std::chrono::nanoseconds since_{};  ///< time of the last line, from the start
  std::string interface_;
};

}  // namespace drydock::capture

#pragma once

#include <chrono>
#include <string>

#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// PEAK's trace (.trc), versions 1.0 to 1.3 and 2.0, 2.1 (PEAK CAN TRC File Format):
///         3)     17700.3  Tx     00000100  8  00 00 00 00 00 00 00 00
///         1      1059.900 DT 1      0300 Rx -  7    00 00 00 00 04 00 00
/// Each version is a list of columns by PEAK's letters: N number, O offset in ms, T type, B bus, I
/// identifier, d direction, R reserved, l bytes of data, L length code, D data. An identifier of
/// more than four digits has 29 bits. Bus n is interface can(n-1). Lines of hardware status, error
/// counters and events contain no frame.
class PcanTrc final : public LineReader {
 public:
  static constexpr std::string_view name = "trc";
  static bool recognises(std::string_view line);
  std::string_view note() const override { return note_; }

 private:
  Reading read_line(std::string_view line) override;
  void read_head(std::string_view line);
  void read_other_start(std::string_view text);
  Reading read_columns(std::string_view line);
  Reading on_bus(std::uint32_t bus, Record record);

  std::string columns_ = "NOILD";  ///< version 1.0: its files do not state a version
  std::chrono::nanoseconds start_{};
  std::string_view note_;
  std::string interface_;
};

}  // namespace drydock::capture

#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// What the times of candump's lines are.
enum class CandumpTimes : std::uint8_t {
  dates,        ///< -t a, A; or there are none
  since_start,  ///< -t z
  pauses        ///< -t d
};

/// The output of candump on the screen, with or without its time (-t a, A, d, z) and flags (-x):
///    (1436509052.249713)  can0  RX - -  18EEFF01   [8]  05 A0 BE 1C 00 A0 A0 C0
///    can0  123   [4]  remote request
/// and its older form, which names the interface once in the head (`interface = can0, ...`):
///    <0x18eeff01> [8] 05 a0 be 1c 00 a0 a0 c0
/// A length of two digits means CAN FD. With -t d a time is the pause since the frame before, which
/// nothing in its line tells: then times go back within the file's first lines, on one interface.
class CandumpScreen final : public LineReader {
 public:
  static constexpr std::string_view name = "candump-screen";
  static bool recognises(std::string_view line);

  Scan scan(Bytes bytes, bool at_end) override;
  void settle(Bytes rest) override;
  std::string_view note() const override;

 private:
  Reading read_line(std::string_view line) override;

  std::string interface_ = "can";
  std::optional<CandumpTimes> times_;  ///< empty: not decided yet
  std::chrono::nanoseconds sum_{0};
};

}  // namespace drydock::capture

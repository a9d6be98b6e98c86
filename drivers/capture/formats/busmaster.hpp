#pragma once

#include <chrono>
#include <string>

#include "drivers/capture/reader.hpp"
#include "drivers/wire/day_clock.hpp"

namespace drydock::capture {

/// BUSMASTER's log of a CAN bus: time, direction, channel, identifier, s (11 bits) or x (29 bits),
/// with r behind it for a remote frame, length, data. Its head says the base and what the times
/// are: of day, since the start, or since the frame before. Source: logs in SavvyCAN's examples and
/// the constants of BUSMASTER's LogObjectCAN.
///    11:49:12:9420 Rx 1 0x023 s 1 40
/// Four digits behind the seconds are tenths of milliseconds; fewer are milliseconds, as SavvyCAN
/// writes them. Channel n is interface can(n-1), as in asc2log; SavvyCAN counts channels from 0.
class Busmaster final : public LineReader {
 public:
  static constexpr std::string_view name = "busmaster";
  static bool recognises(std::string_view line);

 private:
  enum class Times : std::uint8_t { of_day, from_start, from_last };

  Reading read_line(std::string_view line) override;
  void read_head(std::string_view line);
  std::chrono::nanoseconds since_1970(std::chrono::nanoseconds told);

  int base_ = 16;
  Times times_ = Times::of_day;
  std::chrono::nanoseconds date_{}, start_{}, last_{};  ///< `start_` is of its day
  wire::DayClock clock_;
  std::string interface_;
};

}  // namespace drydock::capture

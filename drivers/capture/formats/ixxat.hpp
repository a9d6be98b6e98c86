#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "drivers/capture/reader.hpp"
#include "drivers/wire/day_clock.hpp"

namespace drydock::capture {

/// The tables of IXXAT's programs (HMS): MiniMon, whose layout SavvyCAN writes too, canAnalyser 3
/// and the CANnector. The line with the names of the columns says what stands where, and in which
/// base.
///    "Time","Identifier (hex)","Format","Flags","Data (hex)"
///    "00:30:06.866","184","Std","","00 06 00 16 75 EE 00 3C"
///    "Bus","No","Time (abs)","State","ID (hex)","DLC","Data (hex)","ASCII"
/// Sources: traces in public repositories and the readers of others there; CANnector Log User
/// Manual 4.01.0091.21000, 6.1. Times count from the midnight before the first one: the date in the
/// head of a MiniMon trace may be read in two ways. Bus n is interface can(n-1).
class Ixxat final : public LineReader {
 public:
  static constexpr std::string_view name = "ixxat";
  static bool recognises(std::string_view line);

 private:
  struct Columns {
    char separator = ',';
    std::optional<std::size_t> bus, time, id, format, state, length, data;
    int id_base = 16, data_base = 16;
    bool relative = false;  ///< times are pauses
  };

  static std::optional<Columns> columns_in(std::string_view head);
  Reading read_line(std::string_view line) override;
  std::optional<Record> frame_of(std::string_view line);
  std::chrono::nanoseconds since_midnight(std::chrono::nanoseconds told);

  std::optional<Columns> columns_;
  wire::DayClock clock_;
  std::chrono::nanoseconds sum_{0};
  std::string interface_;
};

}  // namespace drydock::capture

#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// The table that Kvaser's programs make of a Memorator's log ("CSV Frame"). Its head says the base
/// of identifiers and of data, and when the log began, in whole seconds; the times count from the
/// first frame's. Source: KvaLogWriter_CsvFrame and the flags of canlib's canstat.h.
///    Time,Channel,id,Flags,DLC,Data0,...,Data7,Counter,AbsTime
///    0.00100,1,18eeff01,4,8,05,a0,be,1c,00,a0,a0,c0,2,2023-11-14 22:13:20
/// Channel n is interface can(n-1).
class Kvaser final : public LineReader {
 public:
  static constexpr std::string_view name = "kvaser";
  static bool recognises(std::string_view line);
  std::string_view note() const override { return note_; }

 private:
  Reading read_line(std::string_view line) override;
  bool read_head(std::string_view line);
  void read_columns(std::string_view line);
  std::optional<Record> frame_of(std::string_view line);
  std::chrono::nanoseconds since_1970(std::chrono::nanoseconds told);

  char separator_ = ',';
  int id_base_ = 0, data_base_ = 0;  ///< 0: the head does not say it
  bool has_pgns_ = false;            ///< in the place of identifiers
  std::size_t data_columns_ = 0;     ///< 0: no line named the columns
  std::chrono::nanoseconds began_{0};
  std::optional<std::chrono::nanoseconds> first_;
  std::string_view note_;
  std::string interface_;
};

}  // namespace drydock::capture

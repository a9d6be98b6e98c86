#pragma once

#include <chrono>
#include <optional>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"

namespace drydock::capture {

/// One frame of a CAN capture, whatever the format.
struct Record {
  /// UTC since 1970, or since the start of the recording where the file gives no date; empty in
  /// formats without times. A file's local time is taken for UTC: no format says the zone.
  std::optional<std::chrono::nanoseconds> time;
  std::string_view interface;  ///< points into the reader, good until its next call
  wire::CanFrame frame;
};

/// What one line (or block) of a capture holds: a frame, nothing for us, or something damaged. A
/// line may be both: a sound frame glued behind a torn one.
struct Reading {
  std::optional<Record> record;
  bool damaged = false;

  static Reading nothing() { return {}; }
  static Reading damage() { return {std::nullopt, true}; }
  /// The frame, or damage where there is none.
  static Reading of(const std::optional<Record>& record) { return {record, !record}; }
};

}  // namespace drydock::capture

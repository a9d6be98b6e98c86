#pragma once

#include <chrono>
#include <optional>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"

namespace drydock::capture {

/// One frame of a CAN capture, for every format.
struct Record {
  /// UTC since 1970. If the file gives no date: time since the start of the recording. Empty in
  /// formats without times. The reader takes a file's local time as UTC: no format states the zone.
  std::optional<std::chrono::nanoseconds> time;
  std::string_view interface;  ///< points into the reader, valid until its next call
  wire::CanFrame frame;
};

/// The content of one line or block of a capture: a frame, nothing of interest, or damage. One line
/// may hold both: a good frame directly behind a torn one.
struct Reading {
  std::optional<Record> record;
  bool damaged = false;

  static Reading nothing() { return {}; }
  static Reading damage() { return {std::nullopt, true}; }
  /// The frame, or damage if there is no frame.
  static Reading of(const std::optional<Record>& record) { return {record, !record}; }
};

}  // namespace drydock::capture

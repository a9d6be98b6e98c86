#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "rig_config/fault_vocabulary.hpp"

namespace drydock::diagnosis {

/// What is wrong with a device. Where the fault vocabulary has a word for it, the cause has that
/// word.
enum class Cause : std::uint8_t {
  silent,
  port_lost,
  damaged,
  foreign_bytes,
  wrong_baud,
  bus_off,
  error_frames,
  bus_load,
  address_stolen,
  nak,
  drop,
  duplicate,
  reorder,
  delay,
  jitter,
  slow,
  burst,
  clock_step,
  clock_drift,
  stuck,
  bias,
  drift,
  noise,
  spike,
  bottom_lost,
  satellites_blocked,
  antenna_gain,
  hot,
  mounting,
  scale,
  wrong_rate,
  line_full,
  device_error,
  coarse
};

/// One row a cause.
struct CauseFacts {
  Cause cause;
  std::string_view name;  ///< one word for tables and JSON: "bias"
  /// Words of the fault vocabulary that look like this; nobody who only reads the device's data can
  /// tell them apart. Empty: the vocabulary has no such fault.
  std::span<const rig_config::FaultKind> faults;
  std::string_view meaning;  ///< what it is, for a person
  std::string_view advice;   ///< what a person should try first
  bool severe = false;       ///< the device gives nothing, or nothing that is right
  bool misleads = false;     ///< its values look sound and are not: estimators leave them out
  bool mistimes = false;     ///< its values are sound, and their times of validity are not
};

std::span<const CauseFacts> causes();
const CauseFacts& facts_of(Cause cause);

}  // namespace drydock::diagnosis

#pragma once

#include <string>

#include "hil/scorecard/fault_amounts.hpp"
#include "hil/scorecard/reference.hpp"

namespace drydock::scorecard {

/// Who is to blame for an unexpected number: the driver, the sensor that the fault made send it, or
/// nobody, because the number is true or cannot be right.
enum class Blame : std::uint8_t { driver, sensor, nobody };

Blame blame_for(Role role, const rig_config::FaultConfig& fault);

/// Messages with unexpected numbers since the fault's start, from all devices, because a fault of
/// one device must not disturb another.
struct WrongNumbers {
  std::uint64_t of_driver = 0, of_sensor = 0;
  std::uint64_t mistimed = 0;  ///< all their numbers were true together up to 4 s earlier
  std::string example;         ///< the driver's first wrong number, else the first mistimed one
};

WrongNumbers wrong_numbers(const rig_config::Rig& rig, const Window& window, const Pair& pair,
                           const Reference& reference, const RunRecord& run);

}  // namespace drydock::scorecard

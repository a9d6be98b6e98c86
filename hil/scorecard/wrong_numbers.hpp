#pragma once

#include <string>

#include "hil/scorecard/fault_amounts.hpp"
#include "hil/scorecard/reference.hpp"

namespace drydock::scorecard {

/// Who answers for a number that is not as expected: the driver, the sensor that was made to say
/// so, or nobody, because it is true or cannot be otherwise.
enum class Blame : std::uint8_t { driver, sensor, nobody };

Blame blame_for(Role role, const rig_config::FaultConfig& fault);

/// Messages with numbers that are not as expected, from the fault's start on, of any device: a
/// fault of one must not spoil another.
struct WrongNumbers {
  std::uint64_t of_driver = 0, of_sensor = 0;
  std::uint64_t mistimed = 0;  ///< all their numbers were true together up to 4 s before
  std::string example;         ///< the first that is the driver's, else the first mistimed one
};

WrongNumbers wrong_numbers(const rig_config::Rig& rig, const Window& window, const Pair& pair,
                           const Reference& reference, const RunRecord& run);

}  // namespace drydock::scorecard

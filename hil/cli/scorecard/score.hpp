#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hil/cli/scorecard/fault_amounts.hpp"
#include "hil/cli/scorecard/reference.hpp"

namespace drydock::cli::scorecard {

/// What a fault did to one estimator.
struct EstimatorScore {
  std::string name;
  double error_deg = 0;        ///< largest of roll and pitch together, from the fault's start on
  double usual_deg = 0;        ///< the same of the run without faults
  std::optional<double> nees;  ///< mean over the same time; 1 is consistent. Empty: no estimate
  double usual_nees = 0;
  std::optional<double> horizontal_m, usual_m;  ///< of those that give positions
  std::optional<double> recover_s;  ///< behind the fault's end; 0: it stayed sound; empty: not
  std::int64_t lost = 0;            ///< estimates
};

/// What became of one device under one fault: docs/use/scorecard.md.
struct Score {
  std::string device, fault, amount, layer;
  std::optional<double> detect_s;   ///< behind the fault's start; empty: not detected
  std::string sign;                 ///< what the driver gave first
  std::optional<double> recover_s;  ///< behind the fault's end; empty: not within the run
  std::int64_t lost = 0;            ///< messages; below 0: so many more came
  std::int64_t others_lost = 0;     ///< of the rig's other devices
  std::uint64_t wrong = 0;          ///< messages with a number that the driver should have refused
  std::uint64_t mistimed = 0;       ///< messages true at another time than they say
  std::uint64_t lies = 0;           ///< messages with a wrong number that the sensor itself said
  std::string example;              ///< the first wrong number, in words
  std::vector<EstimatorScore> estimators;
};

Score score_of(const rig_config::Rig& rig, const Window& window, const Pair& pair,
               const Reference& reference, const RunRecord& run);

}  // namespace drydock::cli::scorecard

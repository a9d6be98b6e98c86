#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hil/scorecard/fault_amounts.hpp"
#include "hil/scorecard/finding_score.hpp"
#include "hil/scorecard/reference.hpp"

namespace drydock::scorecard {

/// The effect of a fault on one estimator.
struct EstimatorScore {
  std::string name;
  double error_deg = 0;        ///< largest norm of roll and pitch errors since the fault's start
  double usual_deg = 0;        ///< the same in the run without faults
  std::optional<double> nees;  ///< mean while valid over the same time; 1 is consistent; empty:
                               ///< never valid
  double valid_share = 0;      ///< of the estimates over the same time
  double wrong_while_valid_s = 0;  ///< the longest time in which it was more than 5 sigma wrong,
                                   ///< while it said valid
  double usual_nees = 0;
  std::optional<double> horizontal_m, usual_m;  ///< only if the estimator gives positions
  std::optional<double> recover_s;  ///< after the fault's end; 0: it stayed sound; empty: never
  std::int64_t lost = 0;            ///< number of estimates
};

/// The effect of one fault on one device: docs/use/scorecard.md.
struct Score {
  std::string device, fault, amount, layer;
  std::optional<double> detect_s;   ///< after the fault's start; empty: not detected
  std::string sign;                 ///< the driver's first sign
  FindingScore finding;             ///< what the diagnosis said
  std::optional<double> recover_s;  ///< after the fault's end; empty: not within the run
  std::int64_t lost = 0;            ///< messages; negative if more came than without the fault
  std::int64_t others_lost = 0;     ///< messages of the rig's other devices
  std::uint64_t wrong = 0;          ///< messages with a wrong number that the driver should have
                                    ///< refused
  std::uint64_t mistimed = 0;       ///< messages that are true, but at another time than they say
  std::uint64_t lies = 0;           ///< messages with a wrong number that the sensor itself sent
  std::string example;              ///< the first wrong number, in words
  std::vector<EstimatorScore> estimators;
};

Score score_of(const rig_config::Rig& rig, const Window& window, const Pair& pair,
               const Reference& reference, const RunRecord& run);

}  // namespace drydock::scorecard

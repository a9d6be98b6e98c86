#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hil/scorecard/fault_amounts.hpp"
#include "hil/scorecard/run_record.hpp"

namespace drydock::scorecard {

/// What the diagnosis said about one fault.
struct FindingScore {
  std::optional<double> found_s;  ///< the first finding, after the fault's start; empty: none
  std::string word;               ///< the cause that was said longest of the right device, else of
                                  ///< the first one
  bool right_device = false;      ///< that first finding is of the fault's device; for a fault of a
                                  ///< bus, of a device on that bus
  bool right_word = false;        ///< a cause that the fault looks like
  std::uint64_t before = 0;       ///< findings before the fault began: false alarms
  std::vector<std::string> others;  ///< "gnss delay": sound devices that had a finding since the
                                    ///< fault began, each with each of its causes
};

/// `sound`: the findings of the run without faults. Those of bed and sky that it has too are true,
/// and count for nothing.
FindingScore judge_findings(const rig_config::Rig& rig, const Window& window, const Pair& pair,
                            const std::vector<FindingAt>& sound, const RunRecord& run);

}  // namespace drydock::scorecard

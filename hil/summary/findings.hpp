#pragma once

#include <span>
#include <string>
#include <vector>

#include "drivers/host/finding_log.hpp"
#include "hil/report/figure.hpp"
#include "hil/summary/summary.hpp"
#include "rig_config/rig.hpp"

namespace drydock::summary {

/// The findings of a run, with the names of the rig's devices. Times count from `start`.
std::vector<diagnosis::FindingAccount> accounts_of(const host::FindingLog& log,
                                                   const rig_config::Rig& rig,
                                                   measurement::Stamp start);

/// True if the finding is of the device (empty: of any) and was in force at `from_s` or later.
bool counts(const diagnosis::FindingAccount& finding, const std::string& device, double from_s);

/// One line a finding, up to a number that a person can read; "no findings" if there are none.
std::string findings_text(std::span<const diagnosis::FindingAccount> findings);

/// A list of them, as HTML.
std::string findings_list(std::span<const diagnosis::FindingAccount> findings);

/// The figure of a device's measurements, with a shade for each time in which something was wrong
/// with it. No curves: nothing was measured.
report::Figure figure_of(const MeasurementTrace& trace,
                         std::span<const diagnosis::FindingAccount> findings, double end_s);

}  // namespace drydock::summary

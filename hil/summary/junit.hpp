#pragma once

#include <string>

#include "hil/summary/summary.hpp"

namespace drydock::summary {

/// The verdicts of a run as a JUnit XML file, one testcase each, for a CI server to show.
/// `rig_file` is named beside the lines.
std::string to_junit(const Summary& summary, const std::string& rig_file);

/// The same for a run that could not begin: one testcase, in error.
std::string junit_of_failure(const std::string& rig, const std::string& rig_file,
                             const std::string& why);

}  // namespace drydock::summary

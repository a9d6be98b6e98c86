#pragma once

#include <string>

#include "hil/summary/summary.hpp"

namespace drydock::summary {

/// The verdicts of a run as a JUnit XML file for a CI server, one testcase each. Each testcase
/// names `rig_file` and the line of its expectation.
std::string to_junit(const Summary& summary, const std::string& rig_file);

/// The same file for a run that could not begin: one testcase with an error.
std::string junit_of_failure(const std::string& rig, const std::string& rig_file,
                             const std::string& why);

}  // namespace drydock::summary

#pragma once

#include <string>

#include "drivers/diagnosis/finding_account.hpp"

namespace drydock::diagnosis {

/// "12 damaged frames (at most 0)", "yaw rate 31 deg/s (at most 12 deg/s)".
std::string in_words(const EvidenceAccount& evidence);

/// All evidence of a finding in one line.
std::string evidence_text(const FindingAccount& finding);

/// "since 75.2 s", "from 75.2 s to 80.4 s".
std::string when_text(const FindingAccount& finding);

/// "dvl: damaged since 75.2 s: 12 damaged frames (at most 0) — look at the cable". `when` stands in
/// the place of "since 75.2 s".
std::string line_of(const FindingAccount& finding, const std::string& when);
std::string line_of(const FindingAccount& finding);

/// "dvl: no longer damaged after 5.2 s". The finding must be over.
std::string end_line_of(const FindingAccount& finding);

}  // namespace drydock::diagnosis

#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "drivers/diagnosis/finding_account.hpp"

namespace drydock::summary {

/// An array with an object a finding; docs/use/run.md describes the keys.
nlohmann::ordered_json findings_json(std::span<const diagnosis::FindingAccount> findings);

}  // namespace drydock::summary

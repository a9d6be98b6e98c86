#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "hil/summary/summary.hpp"

namespace drydock::summary {

/// The verdict on an estimator's program: every step has one answer, in time, with finite values.
Verdict verdict_of(const std::string& estimator, const pipeline::PeerAccount& program);

/// ", 1200 steps answered after 0.02 ms, 0.31 ms at most".
std::string program_text(const pipeline::PeerAccount& program);
nlohmann::ordered_json program_json(const pipeline::PeerAccount& program);

}  // namespace drydock::summary

#pragma once

#include <string>

#include "hil/score/errors.hpp"
#include "hil/score/score.hpp"

namespace drydock::score {

/// `notes`: what was passed over, a line each.
std::string score_text(const Errors& errors, const Pairs& pairs,
                       const std::vector<std::string>& notes, const ScoreOptions& options);

/// docs/use/score.md describes the keys.
std::string score_json(const Errors& errors, const Pairs& pairs,
                       const std::vector<std::string>& notes, const ScoreOptions& options);

}  // namespace drydock::score

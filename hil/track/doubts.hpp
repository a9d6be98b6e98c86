#pragma once

#include <string>
#include <vector>

#include "estimators/smoothing/track.hpp"
#include "hil/track/gathered.hpp"

namespace drydock::track {

/// What the residuals of a track say against its sensors or against itself: sentences for a person.
std::vector<std::string> doubts_of(const Gathered& gathered, const smoothing::Track& track);

}  // namespace drydock::track

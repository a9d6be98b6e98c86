#pragma once

#include "drivers/bus/outside_values.hpp"
#include "estimators/external/gives.hpp"
#include "estimators/pipeline/peer.hpp"

namespace drydock::external {

/// False if the message has not what the estimator is to give.
bool has_what_it_gives(const bus::OutsideValues& values, Gives gives);

/// `origin`: where the axes of the program's poses begin.
pipeline::OutsideEstimate estimate_of(const bus::OutsideValues& values, Gives gives,
                                      const frame::Position& origin);

}  // namespace drydock::external

#pragma once

#include <span>
#include <string_view>

#include "rig_config/fault.hpp"

namespace drydock::rig_config {

/// A further key of a fault beside its amount.
struct FaultExtra {
  std::string_view key;  ///< unit in the name
  double usual = 0, lowest = 0, highest = 0;
};

/// spike, garbage: the probability for each sample or message. drift: the time until the amount.
std::span<const FaultExtra> extras_of(FaultKind kind);

}  // namespace drydock::rig_config

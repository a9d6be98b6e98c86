#pragma once

#include <variant>

#include "estimators/leveling/augmented_leveling_filter.hpp"
#include "estimators/leveling/leveling_filter.hpp"

namespace drydock::leveling {

/// One of the filters. All filters have the same member functions.
using AnyLevelingFilter = std::variant<LevelingFilter, AugmentedLevelingFilter>;

inline AnyLevelingFilter make_filter(FilterKind kind, const LevelingOptions& options) {
  if (kind == FilterKind::augmented) return AugmentedLevelingFilter{options};
  return LevelingFilter{options};
}

}  // namespace drydock::leveling

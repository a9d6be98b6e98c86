#pragma once

#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::measurement {

/// The earlier of two deadlines. An empty one never comes.
constexpr std::optional<Stamp> earlier(const std::optional<Stamp>& a,
                                       const std::optional<Stamp>& b) {
  if (!a || !b) return a ? a : b;
  return *b < *a ? b : a;
}

}  // namespace drydock::measurement

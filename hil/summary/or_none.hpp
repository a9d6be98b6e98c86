#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace drydock::summary {

/// The number with so many decimals and its unit; "none" for NaN, which an estimate does not give.
inline std::string or_none(double value, int decimals, const char* unit = "") {
  return std::isnan(value) ? "none" : fmt::format("{:.{}f}{}", value, decimals, unit);
}

}  // namespace drydock::summary

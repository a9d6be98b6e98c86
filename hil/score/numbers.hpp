#pragma once

#include <optional>
#include <string_view>

#include "drivers/measurement/stamp.hpp"

namespace drydock::score {

/// Decimal seconds since 1970, to the nanosecond: a double has only about 200 ns there.
std::optional<measurement::Stamp> stamp_of_seconds(std::string_view text);
std::optional<double> number_of(std::string_view text);
std::optional<std::int64_t> whole_number_of(std::string_view text);

}  // namespace drydock::score

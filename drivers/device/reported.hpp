#pragma once

#include <string_view>

/// Words that a driver reports and that others look for.
namespace drydock::device {

inline constexpr std::string_view hot_report = "the DVL is hot and will shut down soon";

}  // namespace drydock::device

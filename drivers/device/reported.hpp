#pragma once

#include <string_view>

/// Words that a driver reports and that others look for.
namespace drydock::device {

inline constexpr std::string_view hot_report = "the DVL is hot and will shut down soon";
/// In the report of a driver whose device refuses a setting.
inline constexpr std::string_view refusal_word = "refuses";

}  // namespace drydock::device

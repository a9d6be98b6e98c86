#pragma once

#include <algorithm>
#include <array>
#include <string_view>

/// Words that a driver reports and that others look for.
namespace drydock::device {

inline constexpr std::string_view hot_report = "the DVL is hot and will shut down soon";
/// In the report of a driver whose device refuses a setting.
inline constexpr std::string_view refusal_word = "refuses";
/// In the report of a driver whose device has an error of its own, or whose node is lost.
inline constexpr std::array<std::string_view, 7> error_words{
    ": emergency 0x", " lost: no heartbeat",  " was stopped", " has restarted",
    " reports",       "failed its self-test", " is in fault"};

constexpr bool tells_error(std::string_view report) {
  return std::ranges::any_of(error_words, [&](std::string_view word) {
    return report.find(word) != std::string_view::npos;
  });
}

}  // namespace drydock::device

#pragma once

#include <chrono>
#include <string>

/// Dates of files. Many captures count from their own start, and such a time is no date.
namespace drydock::info::utc {

/// 2026-11-21T08:00:00Z. Empty: a time before the year 2000.
std::string text(std::chrono::nanoseconds since_1970);

/// ", from 2026-11-21T08:00:00Z", or nothing.
std::string from(std::chrono::nanoseconds since_1970);

}  // namespace drydock::info::utc

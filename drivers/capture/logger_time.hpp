#pragma once

#include <chrono>
#include <optional>
#include <string_view>

#include "drivers/capture/logger_date.hpp"

namespace drydock::capture {

/// A time that a logger, or the talker's TAG block, wrote in front of a sentence.
struct LoggerTime {
  std::chrono::nanoseconds time{};       ///< since 1970, or since midnight
  bool of_day = false;                   ///< since midnight: no date stands beside it
  bool whole_second = false;             ///< it has no fraction
  DateOrder order = DateOrder::unknown;  ///< that its date shows
};

/// The first one in the text: seconds, milliseconds, microseconds or nanoseconds since 1970,
/// `hh:mm:ss` (AM, PM) with any of the dates of date_before(), or `20190326T100500`. UTC unless an
/// offset stands behind it. `known`: the order of dates that earlier lines showed. Empty: none.
std::optional<LoggerTime> logger_time(std::string_view text, DateOrder known = DateOrder::unknown);

/// That of a TAG block, as `\s:GP0001,c:1704067170*hh\` has it: seconds or milliseconds.
std::optional<LoggerTime> tag_block_time(std::string_view text);

}  // namespace drydock::capture

#pragma once

#include <chrono>
#include <optional>
#include <string_view>

namespace drydock::capture {

/// A time that a logger, or the talker's TAG block, wrote in front of a sentence.
struct LoggerTime {
  std::chrono::nanoseconds time{};  ///< since 1970, or since midnight
  bool of_day = false;              ///< since midnight: no date stands beside it
  bool whole_second = false;        ///< it has no fraction
};

/// The first one in the text: ISO 8601 (UTC unless an offset stands behind it), seconds,
/// milliseconds, microseconds or nanoseconds since 1970, `hh:mm:ss`. Empty: none.
std::optional<LoggerTime> logger_time(std::string_view text);

/// That of a TAG block, as `\s:GP0001,c:1704067170*hh\` has it: seconds or milliseconds.
std::optional<LoggerTime> tag_block_time(std::string_view text);

}  // namespace drydock::capture

#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

namespace drydock::capture {

/// Of 10/12/2014 nobody can say what comes first; 10/13/2014 shows it.
enum class DateOrder : std::uint8_t { unknown, day_first, month_first };

struct LoggerDate {
  std::chrono::nanoseconds midnight{};   ///< since 1970
  DateOrder order = DateOrder::unknown;  ///< that its numbers show
};

/// The date at the end of what stands in front of a time of day, or its year behind it, as in
/// `Tue Mar 26 10:05:00 2019`: 2019-03-26, 20190326, 26.03.2019, 03/26/2019, 26 Mar 2019, and the
/// day of the year, 2019:085 and 19+085. `known`: the order where the numbers do not show it.
/// Empty: none, a part of one, or one of which the order is not known.
std::optional<LoggerDate> date_before(std::string_view text, std::string_view behind,
                                      DateOrder known);

/// `YYYYMMDD`.
std::optional<std::chrono::nanoseconds> compact_date(std::string_view digits);

}  // namespace drydock::capture

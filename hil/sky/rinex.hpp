#pragma once

#include <boost/system/result.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hil/sky/ephemeris.hpp"

/// GPS navigation files in the Receiver Independent Exchange Format: RINEX 2.10 table A4,
/// RINEX 3.04 table A6.
namespace drydock::sky {

struct RinexError {
  int line = 0;      ///< from 1
  std::string what;  ///< what is wrong, what is allowed
};

/// Called by result::value() when there is none; throws std::invalid_argument.
[[noreturn]] void throw_exception_from_error(const RinexError& error,
                                             const boost::source_location& where);

struct Navigation {
  double version = 0;
  std::optional<int> leap_seconds;  ///< GPS time ahead of UTC, where the header tells
  std::vector<Ephemeris> records;   ///< of GPS, in file order
  std::size_t passed_over = 0;      ///< records of other systems in a RINEX 3 file
};

/// A day of every GNSS in one file is 20 MB; a day of GPS 500 records. More is told as an error, so
/// that a file that is none cannot take the memory.
inline constexpr std::size_t most_navigation_bytes = 64'000'000;
inline constexpr std::size_t most_navigation_records = 20'000;

/// All GPS records of a file, or its first mistake: nothing is guessed and no record is skipped.
/// toe is the second of week nearest to toc: the week number of old files does not count.
boost::system::result<Navigation, RinexError> read_navigation(std::string_view text);

}  // namespace drydock::sky

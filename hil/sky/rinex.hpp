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
  std::string what;  ///< what is wrong and what is allowed
};

/// Called by result::value() if there is no result; throws std::invalid_argument.
[[noreturn]] void throw_exception_from_error(const RinexError& error,
                                             const boost::source_location& where);

struct Navigation {
  double version = 0;
  std::optional<int> leap_seconds;  ///< GPS time minus UTC, if the header has it
  std::vector<Ephemeris> records;   ///< GPS only, in file order
  std::size_t passed_over = 0;      ///< records of other systems in a RINEX 3 file
};

/// A day of every GNSS in one file is 20 MB, and a day of GPS has 500 records. Larger files are an
/// error, so that a wrong file cannot fill the memory.
inline constexpr std::size_t most_navigation_bytes = 64'000'000;
inline constexpr std::size_t most_navigation_records = 20'000;

/// All GPS records of a file, or its first error. No value is guessed and no record is skipped. toe
/// is the second of week nearest to toc; the week number is ignored, because old files have it
/// wrong.
boost::system::result<Navigation, RinexError> read_navigation(std::string_view text);

}  // namespace drydock::sky

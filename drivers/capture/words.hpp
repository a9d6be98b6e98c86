#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/can/data_length.hpp"

/// The words of a text line in a capture, and the numbers in them.
namespace drydock::capture {

/// Goes through words that are separated by blanks.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  std::string_view next();        ///< empty at the end of the line
  std::string_view peek() const;  ///< the word that next() would give
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

/// A time in the year 2096. Every date, time of day or offset that is read here is earlier, so the
/// sum of two does not overflow.
constexpr std::chrono::nanoseconds latest_time{4'000'000'000'000'000'000};

/// `digits[.digits]` in a unit of 10^exponent ns (9: seconds, 6: milliseconds), to the nanosecond.
std::optional<std::chrono::nanoseconds> parse_time(std::string_view text, int exponent);

/// Days of the Gregorian calendar since 1970, as time. Empty for a date that does not exist.
std::optional<std::chrono::nanoseconds> date_time(int year, unsigned month, unsigned day);

/// `hh:mm:ss[.decimals]`, time since midnight.
std::optional<std::chrono::nanoseconds> parse_clock(std::string_view text);

/// `YYYY-MM-DD`.
std::optional<std::chrono::nanoseconds> parse_date(std::string_view text);

/// A number in the base and nothing else.
std::optional<std::uint32_t> parse_number(std::string_view text, int base);

/// Reads `count` bytes in the base (hex bytes have two digits) into the frame. False if a word is
/// not a byte.
bool read_data(Words& words, std::size_t count, int base, wire::CanFrame& frame);

/// The data sizes of CAN FD, and their length codes.
using wire::is_fd_size;
std::optional<std::uint8_t> size_of_length_code(std::uint32_t code);

/// An error frame without details, for a file that gives none: class CAN_ERR_BUSERROR with eight
/// zeros, as can-utils' asc2log writes it.
wire::CanFrame unspecified_error();

}  // namespace drydock::capture

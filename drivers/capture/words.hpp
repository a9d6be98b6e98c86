#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"

/// Words of a capture's text line, and the numbers in them.
namespace drydock::capture {

/// Walks over words parted by blanks.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  std::string_view next();        ///< empty at the end of the line
  std::string_view peek() const;  ///< the word that next() would give
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

/// In the year 2096. No date, time of day or offset that is read here is later, so that two of them
/// may be added.
constexpr std::chrono::nanoseconds latest_time{4'000'000'000'000'000'000};

/// `digits[.digits]` of a unit that is 10^exponent ns (9: seconds, 6: milliseconds), to the
/// nanosecond.
std::optional<std::chrono::nanoseconds> parse_time(std::string_view text, int exponent);

/// Days of the Gregorian calendar since 1970, as time; empty for a date that there is not.
std::optional<std::chrono::nanoseconds> date_time(int year, unsigned month, unsigned day);

/// `hh:mm:ss[.decimals]` since midnight.
std::optional<std::chrono::nanoseconds> parse_clock(std::string_view text);

/// `YYYY-MM-DD`.
std::optional<std::chrono::nanoseconds> parse_date(std::string_view text);

/// A number of the base, nothing else.
std::optional<std::uint32_t> parse_number(std::string_view text, int base);

/// `count` bytes of the base (hex ones of two digits) into the frame; false where one is none.
bool read_data(Words& words, std::size_t count, int base, wire::CanFrame& frame);

/// Sizes that CAN FD has, and its length codes.
bool is_fd_size(std::size_t size);
std::optional<std::uint8_t> size_of_length_code(std::uint32_t code);

/// An error frame of which the file says no more: class CAN_ERR_BUSERROR with eight zeros, as
/// can-utils' asc2log writes it.
wire::CanFrame unspecified_error();

}  // namespace drydock::capture

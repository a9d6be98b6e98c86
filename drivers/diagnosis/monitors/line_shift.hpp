#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "drivers/diagnosis/monitors/line_length.hpp"

namespace drydock::diagnosis {

/// On a serial line a receiver that says more or less moves the times of all that follows, once.
/// For the next two messages of a stream that is no sign, as far as the longer message explains it:
/// in a real sky satellites come and go every few seconds.
class LineShift {
 public:
  /// `bytes_per_second`: of the line; 0: not known.
  explicit LineShift(double bytes_per_second)
      : satellite_s_(bytes_a_satellite /
                     (bytes_per_second > 0 ? bytes_per_second : slowest_bytes_per_second)) {}

  /// The line_length_of the latest message of a kind, and of the one before; 0: none.
  void note(std::uint32_t before, std::uint32_t length, Stamp at, double period_s) {
    if (before == 0 || before == length) return;
    constexpr auto unlimited = std::numeric_limits<double>::infinity();
    const bool sky = before >= no_satellites && length >= no_satellites;
    const double satellites = std::abs(static_cast<double>(length) - static_cast<double>(before));
    most_s_ = (at < until_ ? most_s_ : 0) + (sky ? satellites * satellite_s_ : unlimited);
    until_ = at + std::clamp<std::chrono::nanoseconds>(measurement::from_seconds(2.5 * period_s),
                                                       shortest, longest);
  }

  /// By how much a message that comes now may have moved. 0: by nothing.
  double most_s(Stamp at) const { return at < until_ ? most_s_ : 0; }

 private:
  /// NMEA 0183 GSV with its share of the sentence; UBX NAV-SAT has 12.
  static constexpr double bytes_a_satellite = 20, slowest_bytes_per_second = 480;
  static constexpr std::chrono::nanoseconds shortest = std::chrono::milliseconds{500},
                                            longest = std::chrono::seconds{5};
  double satellite_s_, most_s_ = 0;
  Stamp until_{};
};

}  // namespace drydock::diagnosis

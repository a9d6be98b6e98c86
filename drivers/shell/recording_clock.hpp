#pragma once

#include <optional>
#include <span>
#include <string>

#include "drivers/device/clock_reader.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/link/uri.hpp"

namespace drydock::shell {

using measurement::Stamp;

/// Whose date the times of a capture have.
enum class DateOf : std::uint8_t {
  capture,   ///< its own, or it has no times
  receiver,  ///< it has none: that of a GNSS receiver in it
  nobody     ///< nobody tells it: the times count from a midnight, 1970-01-01
};

/// What gives a recording (`file:` link) its times.
enum class Pace : std::uint8_t {
  arrival,  ///< the capture keeps when each frame or each read arrived
  device,   ///< it does not, but the device tells its own time
  line      ///< neither: bytes follow each other at the line's rate, frames as on a full bus
};

struct RecordingClock {
  Pace pace = Pace::line;
  device::RecordedTimes times{};  ///< pace device
  bool told_by_receiver = false;  ///< the device tells no time: a GNSS receiver on its line does
  Stamp first{};                  ///< the first time, UTC where the clock is; line: zero
  DateOf date_of = DateOf::capture;
  std::chrono::nanoseconds date{};  ///< of a receiver: what is added to the times of the capture

  std::string in_words() const;
  /// Of the device's messages by its own clock; otherwise empty.
  std::optional<double> usual_rate_hz() const;
  double seconds() const;  ///< from the first to the last of them
};

/// Reads a recording once to its end and decides. The key `clock` of the URI (`line`) forbids the
/// device's clock, `clock=device` prefers it to the capture's times. Frames that came faster than
/// any bus carries them have no times of arrival. A file that cannot be read has pace line. The
/// clock is that of the whole file: where several devices read it, one of them tells the time for
/// all, first a GNSS receiver; where none does, a receiver that no device reads.
RecordingClock clock_of(const link::Uri& uri, std::span<const device::DriverOptions> drivers,
                        device::Travels travels);
inline RecordingClock clock_of(const link::Uri& uri, const device::DriverOptions& driver,
                               device::Travels travels) {
  return clock_of(uri, std::span(&driver, 1), travels);
}

}  // namespace drydock::shell

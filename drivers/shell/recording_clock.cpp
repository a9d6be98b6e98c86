#include "drivers/shell/recording_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "drivers/capture/arrival_times.hpp"
#include "drivers/capture/byte_file.hpp"
#include "drivers/capture/capture_file.hpp"
#include "drivers/link/can/frame_file.hpp"

namespace drydock::shell {
namespace {

using device::ClockReader;
using device::DriverOptions;
using device::RecordedTimes;
using device::Travels;

RecordedTimes times_of_bytes(const link::Uri& uri, ClockReader reader) {
  capture::ByteFile file(uri.target, uri.text_of("format") == "raw",
                         std::string(uri.text_of("interface")));
  std::array<std::uint8_t, 64> piece;
  while (const std::size_t size = file.read(piece)) reader.feed(wire::Bytes(piece).first(size));
  constexpr std::uint8_t line_end[] = {'\n'};  // the last line of a recording may have no end
  reader.feed(wire::Bytes(line_end));
  return reader.finish();
}

RecordedTimes times_of_frames(const link::Uri& uri, ClockReader reader) {
  capture::CaptureFile file = link::capture_of(uri);
  while (const auto record = file.next()) reader.feed(record->frame);
  return reader.finish();
}

RecordedTimes device_times(const link::Uri& uri, const DriverOptions& driver, Travels travels) {
  auto reader = ClockReader::make(driver, travels);
  if (!reader) return {};
  return travels == Travels::as_frames ? times_of_frames(uri, std::move(*reader))
                                       : times_of_bytes(uri, std::move(*reader));
}

capture::ArrivalTimes arrival_times(const link::Uri& uri) {
  capture::CaptureFile file = link::capture_of(uri);
  return capture::arrival_times_of(file);
}

std::optional<std::chrono::nanoseconds> first_read(const link::Uri& uri, std::string line_name) {
  capture::LineFile line(uri.target, false, std::move(line_name));
  const auto first = line.next();
  return first ? first->time : std::nullopt;
}

/// Empty: a file of bytes alone.
std::optional<std::chrono::nanoseconds> first_time(const link::Uri& uri) {
  if (uri.text_of("format") == "raw" || !capture::has_times(uri.target)) return {};
  return first_read(uri, std::string(uri.text_of("interface")));
}

/// A logger that writes whole seconds tells less than a device that tells its own time.
bool has_whole_seconds(const link::Uri& uri) {
  capture::LineFile line(uri.target, false, std::string(uri.text_of("interface")));
  constexpr int enough = 1000;
  for (int lines = 0; lines < enough && line.next(); ++lines) continue;
  return line.has_whole_seconds();
}

/// The lines and buses of one file keep their distances, so they count from the first time in it.
Stamp begin_of_file(const link::Uri& uri, std::chrono::nanoseconds own_first) {
  const auto read = capture::has_times(uri.target) ? first_read(uri, "*") : std::nullopt;
  const auto record = capture::CaptureFile(uri.target, uri.text_of("format"), "").next();
  return Stamp{std::min({own_first, read.value_or(own_first),
                         record ? record->time.value_or(own_first) : own_first})};
}

RecordingClock by_device(RecordingClock clock) {
  clock.pace = Pace::device;
  clock.first = Stamp{clock.times.messages.front().at};
  return clock;
}

}  // namespace

std::string RecordingClock::in_words() const {
  switch (pace) {
    case Pace::arrival: return "times: of the capture";
    case Pace::device:
      return fmt::format(
          "times: of the device's own clock{}",
          times.jumps > 0 ? fmt::format(", which jumped {} times", times.jumps) : "");
    case Pace::line: break;
  }
  return "no times: neither the capture nor the device tells them, so messages follow at the rate "
         "of the line";
}

std::optional<double> RecordingClock::usual_rate_hz() const {
  if (pace != Pace::device) return {};
  return 1 / measurement::seconds(times.usual_step);
}

double RecordingClock::seconds() const {
  const auto& messages = times.messages;
  return messages.empty() ? 0 : measurement::seconds(messages.back().at - messages.front().at);
}

RecordingClock clock_of(const link::Uri& uri, const DriverOptions& driver, Travels travels) {
  const std::string_view wanted = uri.text_of("clock");
  RecordingClock clock;
  if (travels == Travels::as_frames && wanted != "device") {
    if (const auto arrivals = arrival_times(uri); arrivals.are_told()) {
      clock.pace = Pace::arrival;
      clock.first = begin_of_file(uri, *arrivals.first());
      return clock;
    }
  }
  if (travels == Travels::as_bytes && wanted != "device") {
    if (const auto first = first_time(uri)) {
      if (wanted != "line" && has_whole_seconds(uri))
        clock.times = device_times(uri, driver, travels);
      if (!clock.times.messages.empty()) return by_device(std::move(clock));
      clock.pace = Pace::arrival;
      clock.first = begin_of_file(uri, *first);
      return clock;
    }
  }
  if (wanted == "line") return clock;
  clock.times = device_times(uri, driver, travels);
  return clock.times.messages.empty() ? clock : by_device(std::move(clock));
}

}  // namespace drydock::shell

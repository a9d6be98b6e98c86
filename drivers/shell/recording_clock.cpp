#include "drivers/shell/recording_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "drivers/capture/arrival_times.hpp"
#include "drivers/capture/byte_file.hpp"
#include "drivers/capture/capture_file.hpp"
#include "drivers/device/shared_times.hpp"
#include "drivers/link/can/frame_file.hpp"
#include "drivers/shell/receiver_date.hpp"

namespace drydock::shell {
namespace {

using device::ClockReader;
using device::DriverOptions;
using device::RecordedTimes;
using device::Travels;

void read_bytes(const link::Uri& uri, std::vector<ClockReader>& readers) {
  capture::ByteFile file(uri.target, uri.text_of("format") == "raw",
                         std::string(uri.text_of("interface")));
  std::array<std::uint8_t, 64> piece;
  while (const std::size_t size = file.read(piece))
    for (auto& reader : readers) reader.feed(wire::Bytes(piece).first(size));
  constexpr std::uint8_t line_end[] = {'\n'};  // the last line of a recording may have no end
  for (auto& reader : readers) reader.feed(wire::Bytes(line_end));
}

void read_frames(const link::Uri& uri, std::vector<ClockReader>& readers) {
  capture::CaptureFile file = link::capture_of(uri);
  while (const auto record = file.next())
    for (auto& reader : readers) reader.feed(record->frame);
}

struct Told {
  device::Kind by;
  RecordedTimes times;
};

/// What drivers read in one recording.
struct Read {
  std::vector<Told> told;              ///< by driver
  std::vector<device::Places> places;  ///< of their messages
};

Read read_all(const link::Uri& uri, std::span<const DriverOptions> drivers, Travels travels) {
  Read all;
  std::vector<ClockReader> readers;
  for (const auto& driver : drivers) {
    auto reader = ClockReader::make(driver, travels);
    if (!reader) continue;
    readers.push_back(std::move(*reader));
    all.told.push_back({driver.kind, {}});
  }
  if (readers.empty()) return all;
  travels == Travels::as_frames ? read_frames(uri, readers) : read_bytes(uri, readers);
  for (std::size_t i = 0; i < readers.size(); ++i) {
    all.told[i].times = readers[i].finish();
    if (!readers[i].places().empty()) all.places.push_back(readers[i].places());
  }
  return all;
}

/// A receiver whose sentences or frames may stand between those of the driver's device.
DriverOptions receiver_beside(const DriverOptions& driver, Travels travels) {
  DriverOptions receiver;
  receiver.kind = device::Kind::gnss;
  receiver.protocol =
      driver.description && travels == Travels::as_bytes ? "nmea0183" : driver.protocol;
  return receiver;
}

/// The clock of the first GNSS receiver, else of the first device that tells its time. Null: none.
RecordedTimes* clock_in(std::vector<Told>& all) {
  RecordedTimes* first = nullptr;
  for (auto& told : all) {
    if (told.times.messages.empty()) continue;
    if (told.by == device::Kind::gnss) return &told.times;
    if (first == nullptr) first = &told.times;
  }
  return first;
}

/// Fills in the times that the devices tell; none: they stay empty.
void read_device_times(RecordingClock& clock, const link::Uri& uri,
                       std::span<const DriverOptions> drivers, Travels travels) {
  Read own = read_all(uri, drivers, travels);
  RecordedTimes* told = clock_in(own.told);
  if (told != nullptr && drivers.size() == 1) {
    clock.times = std::move(*told);
    return;
  }
  Read beside;
  if (told == nullptr && !own.places.empty()) {
    const DriverOptions receiver = receiver_beside(drivers.front(), travels);
    beside = read_all(uri, std::span(&receiver, 1), travels);
    told = clock_in(beside.told);
    clock.told_by_receiver = told != nullptr;
  }
  if (told == nullptr) {
    for (const auto& one : own.told)
      clock.times.jumps = std::max(clock.times.jumps, one.times.jumps);
    return;
  }
  clock.times = std::move(*told);
  clock.times.messages = device::times_at(clock.times.messages, own.places);
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

bool is_without_date(const link::Uri& uri) {
  capture::LineFile line(uri.target, false, std::string(uri.text_of("interface")));
  return line.next() && line.is_without_date();
}

/// The lines and buses of one file keep their distances, so they count from the first time in it.
Stamp begin_of_file(const link::Uri& uri, std::chrono::nanoseconds own_first) {
  const auto read = capture::has_times(uri.target) ? first_read(uri, "*") : std::nullopt;
  const auto record = capture::CaptureFile(uri.target, uri.text_of("format"), "").next();
  return Stamp{std::min({own_first, read.value_or(own_first),
                         record ? record->time.value_or(own_first) : own_first})};
}

std::string in_times(std::size_t jumps) {
  return jumps == 1 ? "once" : fmt::format("{} times", jumps);
}

RecordingClock by_arrival(RecordingClock clock, const link::Uri& uri,
                          std::chrono::nanoseconds own_first) {
  clock.pace = Pace::arrival;
  if (is_without_date(uri)) {
    const auto date = date_by_receiver(uri);
    clock.date_of = date ? DateOf::receiver : DateOf::nobody;
    clock.date = date.value_or(clock.date);
  }
  clock.first = begin_of_file(uri, own_first) + clock.date;
  return clock;
}

RecordingClock by_device(RecordingClock clock) {
  clock.pace = Pace::device;
  clock.first = Stamp{clock.times.messages.front().at};
  return clock;
}

}  // namespace

std::string RecordingClock::in_words() const {
  switch (pace) {
    case Pace::arrival:
      switch (date_of) {
        case DateOf::receiver:
          return "times: of the capture, which tells no date: it is that of a GNSS receiver in it";
        case DateOf::nobody:
          return "times: of the capture, which tells no date: they count from the midnight before "
                 "the first one, as if that were 1970-01-01";
        case DateOf::capture: break;
      }
      return "times: of the capture";
    case Pace::device:
      return fmt::format("times: of {}{}",
                         told_by_receiver ? "the clock that a GNSS receiver on its line tells"
                                          : "the device's own clock",
                         times.jumps > 0 ? ", which jumped " + in_times(times.jumps) : "");
    case Pace::line: break;
  }
  if (times.jumps > 0)
    return fmt::format(
        "no times: the capture has none, and the device's own clock jumped {}, too often to be "
        "one, "
        "so messages follow at the rate of the line",
        in_times(times.jumps));
  return "no times: neither the capture nor the device tells them, so messages follow at the rate "
         "of the line";
}

std::optional<double> RecordingClock::usual_rate_hz() const {
  if (pace != Pace::device || told_by_receiver) return {};
  return 1 / measurement::seconds(times.usual_step);
}

double RecordingClock::seconds() const {
  const auto& messages = times.messages;
  return messages.empty() ? 0 : measurement::seconds(messages.back().at - messages.front().at);
}

RecordingClock clock_of(const link::Uri& uri, std::span<const DriverOptions> drivers,
                        Travels travels) {
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
        read_device_times(clock, uri, drivers, travels);
      if (!clock.times.messages.empty()) return by_device(std::move(clock));
      return by_arrival(std::move(clock), uri, *first);
    }
  }
  if (wanted == "line") return clock;
  read_device_times(clock, uri, drivers, travels);
  return clock.times.messages.empty() ? clock : by_device(std::move(clock));
}

}  // namespace drydock::shell

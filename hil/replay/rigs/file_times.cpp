#include "hil/replay/rigs/file_times.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "drivers/capture/capture_file.hpp"
#include "drivers/capture/line_file.hpp"
#include "drivers/decode/replayed_device.hpp"

namespace drydock::replay {
namespace {

using measurement::Stamp;
using std::chrono::nanoseconds;

/// The steps between arrivals, of which the first tell how long they are.
class Steps {
 public:
  void add(nanoseconds step) {
    if (step > nanoseconds{0} && steps_.size() < most) steps_.push_back(step);
  }
  /// 99 of 100 are no longer. Sentences come in bursts, and the pause behind one is usual too.
  nanoseconds usual() {
    if (steps_.empty()) return nanoseconds{0};
    const auto at = steps_.begin() + static_cast<std::ptrdiff_t>(steps_.size() * 99 / 100);
    std::ranges::nth_element(steps_, at);
    return *at;
  }

 private:
  static constexpr std::size_t most = 100'000;
  std::vector<nanoseconds> steps_;
};

/// Goes through the reads or frames of a file, whatever they hold.
template <class File>
void fill_in_arrivals(FileTimes& times, File&& file) {
  Steps steps;
  std::optional<Stamp> before;
  while (const auto read = file.next()) {
    if (!read->time) continue;
    const Stamp at{*read->time + times.clock.date};
    if (before) steps.add(at - *before);
    before = std::max(before.value_or(at), at);
    times.first = std::min(times.first, at);
    times.last = std::max(times.last, at);
  }
  times.step = std::max(times.step, steps.usual());
}

/// Its lines and buses belong together.
FileTimes times_of_packets(const std::string& file) {
  FileTimes times{.packets = true, .first = Stamp::max(), .last = Stamp::min()};
  fill_in_arrivals(times, capture::LineFile(file, false, "*"));
  fill_in_arrivals(times, capture::CaptureFile(file, "", ""));
  if (times.first <= times.last) times.clock.pace = shell::Pace::arrival;
  return times;
}

}  // namespace

FileTimes times_of_file(const decode::ReplayOptions& how) {
  if (how.format != "raw" && capture::has_packets(how.capture))
    return times_of_packets(how.capture);
  const auto uri = decode::uri_of(how);
  const auto device = decode::replayed_device(how, uri);
  FileTimes times{.clock = shell::clock_of(uri, device->options().driver, device->travels()),
                  .travels = device->travels()};
  switch (times.clock.pace) {
    case shell::Pace::arrival:
      times.first = times.last = times.clock.first;
      if (times.travels == device::Travels::as_frames)
        fill_in_arrivals(times, capture::CaptureFile(how.capture, how.format, how.interface));
      else
        fill_in_arrivals(times, capture::LineFile(how.capture, how.format == "raw", how.interface));
      break;
    case shell::Pace::device:
      times.first = Stamp{times.clock.times.messages.front().at};
      times.last = Stamp{times.clock.times.messages.back().at};
      times.step = times.clock.times.usual_step;
      break;
    case shell::Pace::line: break;
  }
  return times;
}

}  // namespace drydock::replay

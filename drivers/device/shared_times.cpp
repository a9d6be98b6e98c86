#include "drivers/device/shared_times.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace drydock::device {
namespace {

using measurement::MessageTime;
using measurement::MessageTimes;
using std::chrono::nanoseconds;

/// An instrument may say one thing in several sentences.
constexpr std::size_t most_in_a_burst = 3;

/// The time of a place outside of the clock, at its mean rate.
nanoseconds extrapolated(const MessageTimes& clock, std::uint64_t through) {
  const auto &first = clock.front(), &last = clock.back();
  if (last.through <= first.through) return last.at;
  const double ns_a_place = static_cast<double>((last.at - first.at).count()) /
                            static_cast<double>(last.through - first.through);
  const double places = static_cast<double>(through) - static_cast<double>(last.through);
  return last.at + nanoseconds{std::llround(ns_a_place * places)};
}

/// The messages of the device that says most behind `from` and not behind `to`.
std::span<const std::uint64_t> busiest(const std::vector<Places>& devices, std::uint64_t from,
                                       std::uint64_t to) {
  std::span<const std::uint64_t> most;
  for (const auto& places : devices) {
    const auto begin = std::ranges::upper_bound(places, from);
    const std::span said(begin, std::upper_bound(begin, places.end(), to));
    if (said.size() > most.size()) most = said;
  }
  return most;
}

}  // namespace

MessageTimes times_at(const MessageTimes& clock, const std::vector<Places>& devices) {
  MessageTimes ends = clock;
  std::uint64_t end = 0;
  for (const auto& places : devices)
    if (!places.empty()) end = std::max(end, places.back());
  if (end > clock.back().through) ends.push_back({end, extrapolated(clock, end)});

  MessageTimes times;
  MessageTime before{0, extrapolated(clock, 0)};
  for (const auto& message : ends) {
    const auto said = busiest(devices, before.through, message.through);
    if (said.size() > most_in_a_burst) {
      const auto count = static_cast<std::int64_t>(said.size());
      std::uint64_t end_before = before.through;
      for (std::int64_t i = 1; i < count; ++i) {
        const auto through = said[static_cast<std::size_t>(i - 1)];
        times.push_back({through, before.at + (message.at - before.at) * i / count,
                         through - std::exchange(end_before, through)});
      }
    }
    times.push_back(message);
    before = message;
  }
  return times;
}

}  // namespace drydock::device

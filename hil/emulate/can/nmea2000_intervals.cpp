#include "hil/emulate/can/nmea2000_intervals.hpp"

#include <algorithm>

#include "drivers/wire/j1939/j1939.hpp"

namespace drydock::emulate {
namespace {

constexpr std::chrono::microseconds rounding{1};  // of the times of samples

}  // namespace

Nmea2000Intervals::Nmea2000Intervals(std::span<const std::uint32_t> pgns,
                                     std::chrono::nanoseconds period) {
  for (const std::uint32_t pgn : pgns) {
    sent_.emplace_back();
    sent_.back().pgn = pgn;
    sent_.back().natural = period;
  }
}

Nmea2000Intervals::Sent* Nmea2000Intervals::find(std::uint32_t pgn) {
  const auto found = std::ranges::find(sent_, pgn, &Sent::pgn);
  return found == sent_.end() ? nullptr : &*found;
}

Nmea2000Intervals::Verdict Nmea2000Intervals::set(std::uint32_t pgn,
                                                  std::optional<std::chrono::milliseconds> interval,
                                                  std::optional<std::chrono::milliseconds> offset,
                                                  Stamp now) {
  Sent* const sent = find(pgn);
  if (sent == nullptr) return Verdict::not_supported;
  if (interval && interval->count() > 0 && *interval + rounding < sent->natural)
    return Verdict::too_low;
  sent->interval = interval;
  sent->next = now + offset.value_or(std::chrono::milliseconds{0});
  return Verdict::done;
}

bool Nmea2000Intervals::set_priority(std::uint32_t pgn, std::optional<std::uint8_t> priority) {
  Sent* const sent = find(pgn);
  if (sent != nullptr) sent->priority = priority;
  return sent != nullptr;
}

bool Nmea2000Intervals::passes(std::uint32_t pgn, Stamp at) {
  Sent* const sent = find(pgn);
  if (sent == nullptr || sent->last == at) return sent == nullptr || sent->passes;
  if (sent->last) {
    const auto since = at - *sent->last;
    sent->natural = sent->is_known ? std::min(sent->natural, since) : since;
    sent->is_known = true;
  }
  sent->last = at;
  const auto& interval = sent->interval;
  sent->passes = !interval || (interval->count() > 0 && at + rounding >= sent->next);
  if (interval && sent->passes)
    while (sent->next <= at + rounding) sent->next += *interval;
  return sent->passes;
}

std::optional<std::uint8_t> Nmea2000Intervals::priority(std::uint32_t pgn) const {
  const auto found = std::ranges::find(sent_, pgn, &Sent::pgn);
  return found == sent_.end() ? std::nullopt : found->priority;
}

void IntervalWire::send(const wire::CanFrame& frame) {
  const auto id = wire::j1939::identify(frame);
  if (!id) return out_.send(frame);
  if (!intervals_.passes(id->pgn, at_)) return;
  const auto priority = intervals_.priority(id->pgn);
  if (!priority) return out_.send(frame);
  constexpr unsigned shift = 26;
  wire::CanFrame changed = frame;
  changed.id = (frame.id & ~(std::uint32_t{7} << shift)) | std::uint32_t{*priority} << shift;
  out_.send(changed);
}

}  // namespace drydock::emulate

#include "hil/scorecard/detection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

namespace drydock::scorecard {
namespace {

using Found = std::optional<Sign>;

/// Keeps the earlier sign; if both have the same time, the first.
void keep_earlier(Found& first, Found other) {
  if (other && (!first || other->at_s < first->at_s)) first = std::move(other);
}

Found of_state(const DeviceRecord& device, const Window& window) {
  for (const Change& change : device.changes)
    if (change.at_s >= window.warm_up_s && change.at_s < window.fault_end_s() &&
        change.to != device::State::streaming)
      return Sign{change.at_s, std::string(device::to_string(change.to))};
  return {};
}

/// The difference of two looks at the same time; the clearest sign counts first.
std::string difference_of(const Look& usual, const Look& now) {
  constexpr double rate_share = 0.1;
  if (now.bad_checksums > usual.bad_checksums) return "bad checksum";
  if (now.error_frames > usual.error_frames) return "error frame";
  if (now.trouble.view() != usual.trouble.view() && !now.trouble.view().empty())
    return "trouble reported";
  if (now.skipped > usual.skipped) return "bytes skipped";
  if (now.refused > usual.refused) return "refused by estimator";
  if (now.late > usual.late) return "too late for estimator";
  if (now.rejected > usual.rejected) return "estimator's gate";
  if (now.not_running > usual.not_running) return "estimator waits";
  if (usual.rate_hz && now.rate_hz &&
      std::abs(*now.rate_hz - *usual.rate_hz) > rate_share * *usual.rate_hz)
    return "rate";
  return {};
}

Found of_looks(const DeviceRecord& usual, const DeviceRecord& now, const Window& window) {
  const std::size_t looks = std::min(usual.looks.size(), now.looks.size());
  for (std::size_t i = 0; i < looks && now.looks[i].at_s <= window.fault_end_s(); ++i) {
    if (now.looks[i].at_s < window.warm_up_s) continue;
    if (auto what = difference_of(usual.looks[i], now.looks[i]); !what.empty())
      return Sign{now.looks[i].at_s, std::move(what)};
  }
  return {};
}

bool in_fault(double at_s, const Window& window) {
  return at_s >= window.warm_up_s && at_s < window.fault_end_s();
}

/// The first message that lacks numbers which its kind always has: no bottom lock, no fix.
Found of_missing_numbers(const DeviceRecord& usual, const DeviceRecord& now, const Window& window) {
  std::set<std::pair<std::size_t, std::uint64_t>> known;
  for (const Arrival& arrival : usual.arrivals)
    if (in_fault(arrival.received_s, window)) known.emplace(arrival.kind, arrival.fields);
  const auto lacks = [&](const Arrival& arrival) {
    return std::ranges::any_of(known, [&](const auto& one) {
      return one.first == arrival.kind && one.second != arrival.fields &&
             (one.second & arrival.fields) == arrival.fields;
    });
  };
  for (const Arrival& arrival : now.arrivals)
    if (in_fault(arrival.received_s, window) && !known.contains({arrival.kind, arrival.fields}) &&
        lacks(arrival))
      return Sign{arrival.received_s, "numbers missing"};
  return {};
}

/// The first unusual quality figure of the sensor: accuracy, signal strength, number of satellites.
Found of_quality(std::size_t device, const Reference& reference, const DeviceRecord& now,
                 const Window& window) {
  Found first;
  for (const auto& [key, series] : now.series) {
    if (series.role != Role::quality) continue;
    for (const Sample& sample : series.samples) {
      if (!in_fault(sample.received_s, window) || reference.sound(device, key, sample)) continue;
      keep_earlier(first, Sign{sample.received_s, std::string(series.name)});
      break;
    }
  }
  return first;
}

}  // namespace

std::optional<Sign> first_sign(std::size_t device, const Window& window, const Reference& reference,
                               const RunRecord& run) {
  const DeviceRecord& usual = reference.run().devices.at(device);
  const DeviceRecord& now = run.devices.at(device);
  Found first = of_state(now, window);
  keep_earlier(first, of_missing_numbers(usual, now, window));
  keep_earlier(first, of_quality(device, reference, now, window));
  keep_earlier(first, of_looks(usual, now, window));
  return first;
}

}  // namespace drydock::scorecard

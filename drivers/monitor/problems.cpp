#include "drivers/monitor/problems.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace drydock::monitor {
namespace {

constexpr double least_rate = 0.8;     // of the nominal one
constexpr double most_damaged = 0.01;  // of all frames

bool too_slow(const DeviceView& d) {
  return d.streaming && d.rate_hz > 0 && d.rate_hz < least_rate * d.nominal_rate_hz;
}

/// One frame is not counted: listening may have begun inside it, or between those of one sample.
bool damaged(const DeviceView& d) {
  const auto all = static_cast<double>(d.frames + d.bad_checksums);
  return static_cast<double>(d.bad_checksums) > 1 + most_damaged * all;
}

}  // namespace

std::vector<std::string> problems_of(const DeviceView& d) {
  std::vector<std::string> all;
  if (!d.streaming) all.push_back(d.state + (d.status.empty() ? "" : ": " + d.status));
  if (!d.hint.empty()) all.push_back(d.hint);
  if (!d.shared_with.empty())
    all.push_back("each reads a part of the bytes: also open in " + d.shared_with);
  if (d.finding) all.push_back(d.finding->cause + ": " + d.finding->meaning);
  if (too_slow(d))
    all.push_back(fmt::format("{:.2f} Hz of {:.1f} Hz", d.rate_hz, d.nominal_rate_hz));
  if (damaged(d))
    all.push_back(
        fmt::format("{} of {} frames damaged", d.bad_checksums, d.frames + d.bad_checksums));
  return all;
}

bool all_well(const std::vector<DeviceView>& devices) {
  return !devices.empty() && std::ranges::all_of(devices, [](const DeviceView& device) {
    return problems_of(device).empty();
  });
}

}  // namespace drydock::monitor

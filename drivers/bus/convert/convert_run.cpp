#include <algorithm>
#include <array>

#include "drivers/bus/convert/convert.hpp"
#include "drivers/bus/owned.hpp"

/// Messages about a run that are neither measurements nor estimates: innovations, faults.
namespace drydock::bus {

namespace {

struct Axes {
  const char *names, *unit;
};

/// Axes and unit of the rows of pipeline::InnovationReport.
Axes axes_of(Kind kind) {
  switch (kind) {
    case Kind::dvl: return {"forward, starboard, down", "m/s"};
    case Kind::emlog: return {"ahead", "m/s"};
    case Kind::depth: return {"down", "m"};
    case Kind::gnss: return {"north, east, down", "m"};
    case Kind::attitude: return {"clockwise", "rad"};
    case Kind::imu:
    case Kind::actuator: break;  // actuators drive estimators, nothing is compared with them
  }
  return {"", ""};
}

}  // namespace

void describe(InnovationMessage& message, const Device& source) {
  const auto [names, unit] = axes_of(source.kind);
  message.source = copy_of(source.name);
  message.axes = dds_string_dup(names);
  message.unit = dds_string_dup(unit);
}

void fill(InnovationMessage& message, const Innovation& innovation) {
  message.header.stamp = to_time(innovation.valid_at);
  message.rows = static_cast<std::uint8_t>(innovation.rows.size());
  std::ranges::fill(message.innovation, not_available);
  std::ranges::fill(message.sigma, not_available);
  std::ranges::fill(message.used, false);
  message.nis = 0;
  for (std::size_t i = 0; i < innovation.rows.size(); ++i) {
    const auto& row = innovation.rows[i];
    message.innovation[i] = row.value;
    message.sigma[i] = row.sigma;
    message.used[i] = row.used;
    message.nis += row.value * row.value / (row.sigma * row.sigma);
  }
}

void fill(FaultsMessage& message, std::span<const Fault> faults, Stamp now) {
  release_but_frame(message);
  message.header.stamp = to_time(now);
  auto* next = allocate(message.faults, faults.size());
  for (const auto& fault : faults) {
    *next++ = {copy_of(fault.device),
               copy_of(fault.name),
               copy_of(fault.text),
               fault.in_force(now),
               to_time(fault.since),
               fault.until.has_value(),
               to_time(fault.until.value_or(Stamp{}))};
  }
}

std::vector<Fault> read(const FaultsMessage& message) {
  std::vector<Fault> faults;
  for (std::uint32_t i = 0; i < message.faults._length; ++i) {
    const auto& from = message.faults._buffer[i];
    Fault fault{from.device, from.fault, from.text, to_stamp(from.since), {}};
    if (from.until_known) fault.until = to_stamp(from.until);
    faults.push_back(std::move(fault));
  }
  return faults;
}

}  // namespace drydock::bus

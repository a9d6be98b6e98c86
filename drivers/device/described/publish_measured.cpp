#include "drivers/device/described/publish_measured.hpp"

#include <algorithm>
#include <array>

#include "drivers/device/described/measure.hpp"
#include "drivers/device/vessel/depth_gate.hpp"

namespace drydock::device {
namespace {

using wire::described::Readings;
using wire::described::Target;

constexpr std::array of_an_imu{Target::force_x, Target::force_y, Target::force_z,
                               Target::rate_x,  Target::rate_y,  Target::rate_z};

/// A sample of an IMU has no way to leave a component out.
bool is_complete(const Readings& readings, Kind kind) {
  return kind != Kind::imu ||
         std::ranges::all_of(of_an_imu, [&](Target target) { return readings.has(target); });
}

}  // namespace

void publish_measured(const Readings& readings, measurement::Origin origin,
                      const DriverOptions& options, Output& out) {
  if (!is_complete(readings, options.kind))
    return out.refuse("a sample without all six components was refused");
  origin.device_time = device_time_of(readings);
  const auto measured = measurement_of(readings, origin, options);
  const auto* depth = std::get_if<measurement::DepthSample>(&measured);
  if (!depth || is_possible(*depth, out)) out.publish(measured);
}

}  // namespace drydock::device

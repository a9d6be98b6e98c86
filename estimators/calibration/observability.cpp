#include "estimators/calibration/observability.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/frame/geodetic.hpp"

namespace drydock::calibration {
namespace {

using smoothing::Dive;
using smoothing::Quantity;
using smoothing::Reading;

/// A way between fixes tells a direction to a tenth of a radian from so many sigmas on.
constexpr double shortest_way_sigmas = 10;

bool has(const Dive& dive, Quantity quantity) {
  return std::ranges::find(dive.readings, quantity, &Reading::quantity) != dive.readings.end();
}

bool tells_sinking(const Dive& dive) {
  return has(dive, Quantity::depth) || std::ranges::any_of(dive.readings, [](const Reading& r) {
           return r.quantity == Quantity::fix && std::isfinite(r.value.z());
         });
}

bool is_velocity_of(const Reading& reading, std::uint16_t device) {
  return (reading.quantity == Quantity::bottom || reading.quantity == Quantity::log) &&
         reading.device == device && std::isfinite(reading.value.x());
}

frame::Position place_of(const Reading& fix) { return {fix.value.x(), fix.value.y(), 0}; }

/// True if velocities of the device, or of any where it gives none, lead from a fix to another one
/// that is some way off.
bool fixes_span_a_way(const Dive& dive, std::uint16_t device) {
  const bool any = std::ranges::none_of(
      dive.readings, [&](const Reading& r) { return is_velocity_of(r, device); });
  const Reading* first = nullptr;
  bool moved = false;
  for (const Reading& reading : dive.readings) {
    moved |= first != nullptr && is_velocity_of(reading, any ? reading.device : device);
    if (reading.quantity != Quantity::fix) continue;
    if (first == nullptr) first = &reading;
    if (moved && frame::ned_offset(place_of(*first), place_of(reading)).norm() >
                     shortest_way_sigmas * std::hypot(first->sigma.x(), reading.sigma.x()))
      return true;
  }
  return false;
}

}  // namespace

std::string unobservable(const Parameter& parameter, const Dive& dive) {
  const bool of_dvl = std::ranges::any_of(dive.readings, [&](const Reading& r) {
    return r.quantity == Quantity::bottom && r.device == parameter.device;
  });
  switch (parameter.unknown) {
    case Unknown::pitch:
      return tells_sinking(dive) ? "" : "no depth: nothing says how fast the vehicle sank";
    case Unknown::scale:
      // The scale of a log is also told by a bottom track beside it.
      if (!of_dvl && has(dive, Quantity::bottom)) return {};
      break;
    case Unknown::yaw:
    case Unknown::latency:  // against the receiver
    case Unknown::lever_ahead:
    case Unknown::lever_starboard:
    case Unknown::deviation_constant:
    case Unknown::deviation_sine:
    case Unknown::deviation_cosine: break;
  }
  if (fixes_span_a_way(dive, parameter.device)) return {};
  if (!has(dive, Quantity::fix))
    return of_dvl ? "no fix while bottom locked: nothing says where the vehicle really went"
                  : "no fix: nothing says where the vehicle really went";
  return "no way between two fixes was measured: nothing says where the vehicle really went";
}

}  // namespace drydock::calibration

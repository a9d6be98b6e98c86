#include "drivers/host/integrity_status.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/measurement/units.hpp"

namespace drydock::host {
namespace {

constexpr std::chrono::seconds period{1};
/// An estimate that is older is not valid: the longest gap of an IMU that its estimators bridge.
constexpr std::chrono::nanoseconds oldest = std::chrono::milliseconds{500};

/// An estimate that came by the bus has no bounds: its estimator tells them in a status of its own.
bool promises(const bus::Integrity& integrity) {
  return !integrity.valid || integrity.roll_bound_rad > 0;
}

bus::DeviceStatus status_of(const std::string& name, const bus::Integrity& integrity) {
  bus::DeviceStatus status{.level = integrity.valid ? bus::Level::ok : bus::Level::warn,
                           .name = name + "/integrity",
                           .message = integrity.valid ? "valid" : "not valid",
                           .hardware_id = name,
                           .values = {{"valid", integrity.valid ? "true" : "false"}}};
  const auto add = [&](const char* key, double value) {
    status.values.emplace_back(key, fmt::format("{:.6g}", value));
  };
  add("roll_bound_deg", integrity.roll_bound_rad * units::degrees_per_radian);
  add("pitch_bound_deg", integrity.pitch_bound_rad * units::degrees_per_radian);
  if (integrity.heading_bound_rad)
    add("heading_bound_deg", *integrity.heading_bound_rad * units::degrees_per_radian);
  if (integrity.horizontal_bound_m) add("horizontal_bound_m", *integrity.horizontal_bound_m);
  return status;
}

}  // namespace

IntegrityStatuses::IntegrityStatuses(std::vector<std::string> estimators) {
  for (auto& name : estimators) told_.push_back({.name = std::move(name)});
}

std::optional<bus::DeviceStatus> IntegrityStatuses::take(const Estimate& estimate) {
  if (!promises(estimate.integrity)) return {};
  Told& told = told_.at(estimate.estimator);
  const bool valid = estimate.integrity.valid;
  const auto at = estimate.attitude.valid_at;
  if (told.estimate) told.pace = at - *told.estimate;
  told.estimate = at;
  told.came = now_;
  told.told_old = {};
  if (valid == told.valid && at - told.at < period && told.at <= at) return {};
  told.at = at;
  told.valid = valid;
  return status_of(told.name, estimate.integrity);
}

bool IntegrityStatuses::Told::is_too_old(measurement::Stamp now) const {
  if (!estimate || came == measurement::Stamp{} || now - told_old < period) return false;
  return now - came > std::max(oldest, 5 * pace / 2);
}

bus::DeviceStatus IntegrityStatuses::outdated(Told& told) const {
  told.told_old = now_;
  told.valid = false;
  const double age_s = measurement::seconds(now_ - told.came);
  return {.level = bus::Level::warn,
          .name = told.name + "/integrity",
          .message = fmt::format("not valid: no estimate for {:.1f} s", age_s),
          .hardware_id = told.name,
          .values = {{"valid", "false"}}};
}

}  // namespace drydock::host

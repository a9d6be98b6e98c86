#include "hil/replay/replay_lines.hpp"

#include <cmath>

#include "drivers/measurement/units.hpp"
#include "drivers/text/measurement_fields.hpp"

namespace drydock::replay {

namespace {

double seconds_of(measurement::Stamp at) { return measurement::seconds(at.time_since_epoch()); }

/// Empty if the angle is not known.
std::optional<double> in_degrees(std::optional<double> angle) {
  return angle ? std::optional(*angle * units::degrees_per_radian) : std::nullopt;
}

void attitude_fields(text::JsonWriter& json, const bus::Attitude& e) {
  json.field("roll_deg", e.roll_rad * units::degrees_per_radian);
  json.field("pitch_deg", e.pitch_rad * units::degrees_per_radian);
  json.field("heading_deg", in_degrees(e.yaw_rad));
  json.field("roll_sigma_deg", std::sqrt(e.covariance(0, 0)) * units::degrees_per_radian);
  json.field("pitch_sigma_deg", std::sqrt(e.covariance(1, 1)) * units::degrees_per_radian);
}

void navigation_fields(text::JsonWriter& json, const bus::Navigation& n) {
  json.field("latitude_deg", n.latitude_rad * units::degrees_per_radian);
  json.field("longitude_deg", n.longitude_rad * units::degrees_per_radian);
  json.field("height_m", n.height_m);
  json.field("position_sigma_m", std::sqrt(n.covariance(0, 0) + n.covariance(1, 1)));
  json.field("velocity_ned_mps", n.velocity_ned);
}

}  // namespace

void ReplayLines::on_measurement(const measurement::Measurement& measurement) {
  std::visit(
      [&](const auto& m) {
        lines_.line([&](text::JsonWriter& json) {
          json.field("device", std::string_view(rig_.devices.at(m.origin.device).name));
          json.field("type", type_of(m));
          json.field("valid_at_s", seconds_of(m.origin.valid_at));
          json.field("received_at_s", seconds_of(m.origin.received_at));
          json.fields(m);
        });
      },
      measurement);
}

void ReplayLines::on_estimate(const host::Estimate& e) {
  lines_.line([&](text::JsonWriter& json) {
    json.field("estimator", std::string_view(rig_.estimators.at(e.estimator).name));
    json.field("valid_at_s", seconds_of(e.attitude.valid_at));
    if (e.navigation) navigation_fields(json, *e.navigation);
    attitude_fields(json, e.attitude);
  });
}

}  // namespace drydock::replay

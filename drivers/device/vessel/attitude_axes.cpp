#include "drivers/device/vessel/attitude_axes.hpp"

#include <cmath>
#include <numbers>

namespace drydock::device {

namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;
using measurement::AttitudeSample;
using measurement::HeadingReference;

double in_circle(double angle_rad) {
  constexpr double circle = 2 * std::numbers::pi;
  const double turned = std::fmod(angle_rad, circle);
  return turned < 0 ? turned + circle : turned;
}

std::optional<double> true_heading(const AttitudeSample& m) {
  if (m.reference == HeadingReference::true_north) return m.heading_rad;
  if (m.reference == HeadingReference::unknown || !m.variation_rad) return {};
  // A compass without a deviation table leaves the deviation out: then it is part of its error.
  return in_circle(*m.heading_rad + m.deviation_rad.value_or(0) + *m.variation_rad);
}

}  // namespace

AttitudeAxes::AttitudeAxes(const DriverOptions& options)
    : mounting_(options.mounting),
      error_rad_(options.compass_error_rad),
      level_(tilt_of(mounting_.to_sensor(Vector3d::UnitZ()))) {}

AttitudeAxes::Tilt AttitudeAxes::tilt_of(const Vector3d& down) {
  return {std::atan2(down.y(), down.z()), std::atan2(-down.x(), std::hypot(down.y(), down.z()))};
}

void AttitudeAxes::tilt(const std::optional<double>& roll_rad,
                        const std::optional<double>& pitch_rad, AttitudeSample& into, Output& out) {
  if (mounting_.is_identity()) {
    into.roll_rad = roll_rad;
    into.pitch_rad = pitch_rad;
  } else if (roll_rad && pitch_rad) {
    last_ = {*roll_rad, *pitch_rad};
    last_at_ = into.origin.valid_at;
    const Vector3d down{-std::sin(*pitch_rad), std::cos(*pitch_rad) * std::sin(*roll_rad),
                        std::cos(*pitch_rad) * std::cos(*roll_rad)};
    const Tilt body = tilt_of(mounting_.to_body(down));
    into.roll_rad = body.roll_rad;
    into.pitch_rad = body.pitch_rad;
  } else if (roll_rad || pitch_rad) {
    out.report("the compass is mounted turned and gives only one of roll and pitch: no tilt");
  }
}

void AttitudeAxes::heading(double heading_rad, AttitudeSample& into) const {
  const bool known = last_ && into.origin.valid_at - last_at_ <= tilt_counts_for;
  const double turn = mounting_.is_identity() ? 0 : turn_to_body(known ? *last_ : level_);
  into.heading_rad = in_circle(heading_rad + turn);
  into.true_heading_rad = true_heading(into);
  const double error = error_at(into.true_heading_rad.value_or(*into.heading_rad));
  if (error == 0) return;
  into.heading_rad = in_circle(*into.heading_rad - error);
  into.true_heading_rad = true_heading(into);
}

/// The error belongs to the heading without it, which a few repetitions find: it is a small angle.
double AttitudeAxes::error_at(double shown_rad) const {
  const auto& [constant, sine, cosine] = error_rad_;
  double error = 0;
  for (int i = 0; i < 8; ++i) {
    const double heading = shown_rad - error;
    error = constant + sine * std::sin(heading) + cosine * std::cos(heading);
  }
  return error;
}

double AttitudeAxes::turn_to_body(const Tilt& sensor) const {
  const Vector3d bow =
      AngleAxisd(sensor.pitch_rad, Vector3d::UnitY()) *
      (AngleAxisd(sensor.roll_rad, Vector3d::UnitX()) * mounting_.to_sensor(Vector3d::UnitX()));
  return std::atan2(bow.y(), bow.x());
}

}  // namespace drydock::device

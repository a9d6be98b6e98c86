#include "drivers/device/described/publish_measured.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "drivers/device/described/measure.hpp"
#include "drivers/device/described/quaternion_attitude.hpp"
#include "drivers/device/gnss/gnss_gate.hpp"
#include "drivers/device/imu/imu_sample.hpp"
#include "drivers/device/vessel/attitude_gate.hpp"
#include "drivers/device/vessel/depth_gate.hpp"
#include "drivers/wire/described/description.hpp"

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

bool is_possible_imu(const Readings& r, Output& out) {
  using enum Target;
  const bool good = believable({r.get(rate_x), r.get(rate_y), r.get(rate_z)}, most_rate_radps) &&
                    believable({r.get(force_x), r.get(force_y), r.get(force_z)}, most_force_mps2);
  if (!good) out.refuse("a sample beyond 100 rad/s or 2000 m/s2 was dropped: damaged on its way");
  return good;
}

bool are_possible_surfaces(const Readings& r, Output& out) {
  using enum Target;
  const bool good =
      believable({r.get(rudder), r.get(stern_plane), r.get(bow_plane)}, std::numbers::pi / 2);
  if (!good) out.refuse("a surface beyond 90 degrees was dropped: damaged on its way");
  return good;
}

measurement::HeadingReference reference_of(const Readings& r) {
  using enum measurement::HeadingReference;
  if (!r.has(Target::heading)) return r.has(Target::magnetic_heading) ? magnetic_north : unknown;
  const double code = r.get(Target::heading_reference).value_or(0);
  if (code == 0) return true_north;
  return code == 1 ? magnetic_north : unknown;
}

bool is_possible_attitude(const Readings& r, Output& out) {
  using enum Target;
  return is_possible_heading(r.get(heading), r.get(deviation), r.get(variation), out) &&
         is_possible_heading(r.get(magnetic_heading), {}, {}, out) &&
         is_possible_tilt(r.get(roll), r.get(pitch), out) &&
         is_possible_turn(r.get(rate_of_turn), out);
}

/// True if the device's time is a time of day, and no message says of which.
bool has_no_date(const wire::described::Plan& plan) {
  bool of_day = false;
  for (const auto& field : plan.fields) {
    if (field.target == Target::date) return false;
    of_day |= field.notation.digits == wire::described::Digits::clock;
  }
  return of_day;
}

}  // namespace

MeasuredPublisher::MeasuredPublisher(const DriverOptions& options)
    : options_(options),
      axes_(options),
      log_(options),
      dvl_(options),
      tells_no_date_(has_no_date(options.description->plan)) {}

void MeasuredPublisher::publish(const Readings& readings, measurement::Origin origin, Output& out) {
  if (!is_complete(readings, options_.kind))
    return out.refuse("a sample without all six components was refused");
  origin.device_time = device_time_of(readings);
  if (origin.device_time && tells_no_date_)
    origin.device_time = day_.since_first_midnight(*origin.device_time);
  if (options_.kind == Kind::attitude) {
    if (!has_quaternion(readings)) return publish_attitude(readings, origin, out);
    const auto turned = with_angles(readings);
    if (!turned) return out.refuse("a quaternion whose length is not 1 was refused");
    return publish_attitude(*turned, origin, out);
  }
  if (options_.kind == Kind::imu && !is_possible_imu(readings, out)) return;
  if (options_.kind == Kind::actuator && !are_possible_surfaces(readings, out)) return;
  auto measured = measurement_of(readings, origin, options_);
  if (auto* dvl = std::get_if<measurement::BottomVelocity>(&measured))
    return dvl_.publish(*dvl, {}, out);
  if (auto* log = std::get_if<measurement::WaterSpeed>(&measured)) {
    log->distance_m = log_.way(log->distance_m);
    if (!log_.resolve(readings.get(Target::longitudinal), readings.get(Target::transverse), *log,
                      out))
      return;
  }
  if (const auto* fix = std::get_if<measurement::GnssFix>(&measured))
    return publish_possible(*fix, out);
  const auto* depth = std::get_if<measurement::DepthSample>(&measured);
  if (!depth || is_possible(*depth, out)) out.publish(measured);
}

/// The tilt comes first: the heading of turned axes depends on it.
void MeasuredPublisher::publish_attitude(const Readings& readings,
                                         const measurement::Origin& origin, Output& out) {
  if (!is_possible_attitude(readings, out)) return;
  measurement::AttitudeSample result;
  result.origin = origin;
  result.reference = reference_of(readings);
  result.deviation_rad = readings.get(Target::deviation);
  result.variation_rad = readings.get(Target::variation);
  result.rate_of_turn_radps = readings.get(Target::rate_of_turn);
  axes_.tilt(readings.get(Target::roll), readings.get(Target::pitch), result, out);
  const auto heading = readings.get(Target::heading);
  const auto sent = heading ? heading : readings.get(Target::magnetic_heading);
  if (sent) axes_.heading(*sent, result);
  out.publish(result);
}

}  // namespace drydock::device

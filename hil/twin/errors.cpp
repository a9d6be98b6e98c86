#include "hil/twin/errors.hpp"

#include "estimators/frame/attitude.hpp"
#include "hil/characterize/samples.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::twin {
namespace {

using measurement::Measurement;

/// What a perfect sensor would say instead of a measurement, as a driver tells it: in body axes.
class Perfect {
 public:
  Perfect(const rig_config::DeviceConfig& device, const motion::Trajectory& track)
      : mounting_(sensor::mounting_of(device)), track_(track) {}

  Measurement operator()(const measurement::ImuSample& m) const {
    auto perfect = sensor::ideal_imu(track_, m.origin.valid_at, mounting_);
    perfect.specific_force = mounting_.sensor_to_body * perfect.specific_force;
    perfect.angular_rate = mounting_.sensor_to_body * perfect.angular_rate;
    return perfect;
  }
  Measurement operator()(const measurement::BottomVelocity& m) const {
    measurement::BottomVelocity perfect;
    perfect.velocity =
        mounting_.sensor_to_body * sensor::velocity_at(track_.at(m.origin.valid_at), mounting_);
    return perfect;
  }
  Measurement operator()(const measurement::WaterSpeed& m) const {
    return sensor::ideal_log(track_, m.origin.valid_at, {.lever_arm_m = mounting_.lever_arm_m});
  }
  /// A sensor that tells only a depth is compared by its depth.
  Measurement operator()(const measurement::DepthSample& m) const {
    auto perfect = sensor::ideal_depth(track_.at(m.origin.valid_at), track_.ocean(), mounting_);
    if (!m.pressure_pa) perfect.pressure_pa.reset();
    return perfect;
  }
  Measurement operator()(const measurement::GnssFix& m) const {
    return sensor::ideal_gnss(track_.at(m.origin.valid_at), mounting_);
  }
  Measurement operator()(const measurement::AttitudeSample& m) const {
    return sensor::ideal_attitude(track_.at(m.origin.valid_at), {});
  }
  Measurement operator()(const measurement::ActuatorState& m) const { return m; }
  Measurement operator()(const measurement::GnssSatellites& m) const { return m; }

 private:
  sensor::Mounting mounting_;
  const motion::Trajectory& track_;
};

characterize::Subject subject_of(const rig_config::DeviceConfig& device) {
  characterize::Subject subject;
  subject.name = device.name;
  subject.kind = device.kind;
  subject.sensor_to_body = sensor::mounting_of(device).sensor_to_body;
  return subject;
}

bool has_position(const Measurement& m) {
  const auto* fix = std::get_if<measurement::GnssFix>(&m);
  return fix != nullptr && fix->position;
}

/// What of a measurement can be compared: the true heading where the sensor tells it, and no
/// position where the track has the antenna under water.
Measurement comparable(Measurement m, const Measurement& ideal) {
  if (auto* compass = std::get_if<measurement::AttitudeSample>(&m))
    if (compass->true_heading_rad) compass->heading_rad = compass->true_heading_rad;
  if (auto* fix = std::get_if<measurement::GnssFix>(&m))
    if (!has_position(ideal)) fix->position.reset();
  return m;
}

}  // namespace

std::vector<Error> errors_of(std::span<const Measurement> measured,
                             const rig_config::DeviceConfig& device,
                             const motion::Trajectory& track) {
  if (device.kind == measurement::Kind::actuator) return {};
  const Perfect perfect(device, track);
  characterize::Samples said(subject_of(device)), should_say(subject_of(device));
  std::vector<Error> errors;
  bool has_origin = false;
  for (const auto& m : measured) {
    const Measurement ideal = std::visit(perfect, m);
    // Positions count from the first one: both from the same.
    if (!has_origin && has_position(ideal)) {
      said.add(ideal);
      should_say.add(ideal);
      has_origin = true;
    }
    said.add(comparable(m, ideal));
    should_say.add(ideal);
    Error error{.valid_at = measurement::origin_of(m).valid_at};
    for (std::size_t place = 0; place < 2; ++place)
      error.of[place] = said.quantities[place].back() - should_say.quantities[place].back();
    if (device.kind == measurement::Kind::attitude)
      for (double& angle : error.of[0]) angle = frame::wrap_pi(angle);
    errors.push_back(error);
  }
  return errors;
}

}  // namespace drydock::twin

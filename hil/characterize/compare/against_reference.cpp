#include <cmath>
#include <numbers>

#include "hil/characterize/compare/velocity_comparison.hpp"
#include "hil/characterize/device_figures.hpp"

namespace drydock::characterize {
namespace {

using rig_config::DeviceKind;

/// `value_of(i)` of each sample that has this value, at its valid_at.
template <class ValueOf>
Signal signal_of(const Samples& samples, ValueOf value_of) {
  Signal signal;
  for (std::size_t i = 0; i < samples.origins.size(); ++i) {
    const double value = value_of(i);
    if (!std::isfinite(value)) continue;
    signal.t_s.push_back(measurement::seconds(samples.origins[i].valid_at.time_since_epoch()));
    signal.value.push_back(value);
  }
  return signal;
}

Signal body_axis(const Samples& samples, std::size_t place, Eigen::Index axis) {
  return signal_of(samples, [&](std::size_t i) {
    return Eigen::Vector3d(samples.subject.sensor_to_body * samples.quantities[place][i])[axis];
  });
}

Signal sensor_axis(const Samples& samples, std::size_t place, Eigen::Index axis) {
  return signal_of(samples, [&](std::size_t i) { return samples.quantities[place][i][axis]; });
}

/// Horizontal speed from a GNSS velocity.
Signal speed(const Samples& gnss) {
  return signal_of(gnss, [&](std::size_t i) {
    return std::hypot(gnss.quantities[1][i].x(), gnss.quantities[1][i].y());
  });
}

/// A DVL's velocity at the place of a log, in body axes: v + w x r.
Signal velocity_at_log(const Samples& dvl, const Samples& log, const Samples* imu,
                       Eigen::Index axis) {
  const Eigen::Vector3d arm = log.subject.lever_arm_m - dvl.subject.lever_arm_m;
  if (imu == nullptr || arm.isZero() || dvl.origins.empty()) return body_axis(dvl, 0, axis);
  const auto zero = dvl.origins.front().valid_at;
  const Track rates(*imu, imu->quantities[0], zero);
  return signal_of(dvl, [&](std::size_t i) {
    const auto rate = rates.at(measurement::seconds(dvl.origins[i].valid_at - zero));
    if (!rate) return std::nan("");
    const Eigen::Vector3d in_body = imu->subject.sensor_to_body * *rate;
    return Eigen::Vector3d(dvl.subject.sensor_to_body * dvl.quantities[0][i] +
                           in_body.cross(arm))[axis];
  });
}

/// The course without jumps at whole turns. It is given only where the vehicle moves.
Signal course(const Samples& gnss) {
  constexpr double slowest_mps = 0.5;
  double last = 0;
  return signal_of(gnss, [&, begun = false](std::size_t i) mutable {
    const auto& v = gnss.quantities[1][i];
    if (!(std::hypot(v.x(), v.y()) > slowest_mps)) return std::nan("");
    const double here = std::atan2(v.y(), v.x());
    last = begun ? last + std::remainder(here - last, 2 * std::numbers::pi) : here;
    begun = true;
    return last;
  });
}

/// The integral of the rate about the body's z axis.
Signal turn(const Samples& imu) {
  Signal angle = body_axis(imu, 0, 2);
  double sum = 0, rate = angle.value.empty() ? 0 : angle.value[0];
  for (std::size_t i = 1; i < angle.value.size(); ++i) {
    sum += (rate + angle.value[i]) / 2 * (angle.t_s[i] - angle.t_s[i - 1]);
    rate = angle.value[i];
    angle.value[i] = sum;
  }
  if (!angle.value.empty()) angle.value[0] = 0;
  return angle;
}

class Comparisons {
 public:
  explicit Comparisons(const Samples& reference) : reference_(reference.subject.name) {}

  void add(std::string what, const Signal& sensor, const Signal& reference, int place, int axis,
           bool with_drift = false) {
    auto comparison = compare(sensor, reference, with_drift);
    if (!comparison) return;
    comparison->what = std::move(what);
    all.push_back({reference_, place, axis, std::move(*comparison)});
  }
  void add(const VelocityComparison& found) {
    for (const int axis : {0, 1}) {
      Comparison comparison;
      comparison.what = axis == 0 ? "over ground, x" : "over ground, y";
      comparison.blocks = found.blocks;
      comparison.scale = found.scale;
      comparison.angle_rad = found.angle_rad;
      comparison.delay_s = found.delay_s;
      comparison.bias = found.bias[static_cast<std::size_t>(axis)];
      comparison.residual = found.residual;
      all.push_back({reference_, 0, axis, std::move(comparison)});
    }
  }
  std::vector<AgainstReference> all;

 private:
  std::string reference_;
};

/// Compares each axis of the sensor's own frame with the same axis of the reference, turned into
/// that frame.
void add_axes(Comparisons& to, const Samples& sensor, const Samples& reference) {
  Samples turned = reference;
  const Eigen::Matrix3d turn_back =
      sensor.subject.sensor_to_body.transpose() * reference.subject.sensor_to_body;
  if (!turn_back.isIdentity(0))
    for (auto& series : turned.quantities)
      for (auto& value : series) value = turn_back * value;
  for (const Quantity& quantity : quantities_of(sensor.subject.kind)) {
    const auto place = static_cast<std::size_t>(quantity.place);
    for (int axis = 0; axis < 3; ++axis)
      to.add(std::string(quantity.name) + " " +
                 std::string(quantity.axes[static_cast<std::size_t>(axis)]),
             sensor_axis(sensor, place, axis), sensor_axis(turned, place, axis), quantity.place,
             axis);
  }
}

}  // namespace

std::vector<AgainstReference> against(const Samples& sensor, const Samples& reference,
                                      const Samples* inertial) {
  Comparisons found(reference);
  const auto pair = [&](DeviceKind a, DeviceKind b) {
    return sensor.subject.kind == a && reference.subject.kind == b;
  };
  using enum measurement::Kind;
  if (sensor.subject.kind == reference.subject.kind) {
    add_axes(found, sensor, reference);
  } else if (pair(dvl, gnss)) {
    if (reference.origins.empty()) return {};
    if (const auto compared = compare(AtOnePlace(sensor, reference, inertial)))
      found.add(*compared);
  } else if (pair(emlog, dvl)) {
    found.add("ahead, current and all", sensor_axis(sensor, 0, 0),
              velocity_at_log(reference, sensor, inertial, 0), 0, 0);
    found.add("across, current and all", sensor_axis(sensor, 0, 1),
              velocity_at_log(reference, sensor, inertial, 1), 0, 1);
  } else if (pair(emlog, gnss)) {
    found.add("ahead, current and all", sensor_axis(sensor, 0, 0), speed(reference), 0, 0);
  } else if (pair(imu, gnss)) {
    found.add("turn about z, level", turn(sensor), course(reference), 0, 2, true);
  }
  return std::move(found.all);
}

}  // namespace drydock::characterize

#include "hil/sensor/increments.hpp"

namespace drydock::sensor {

namespace {

using Eigen::Vector3d;
using motion::Truth;

constexpr std::chrono::nanoseconds longest_piece{10'000'000};

/// Simpson's rule.
Vector3d mean(const Vector3d& begin, const Vector3d& middle, const Vector3d& end) {
  return (begin + 4 * middle + end) / 6;
}

Vector3d force_but_for_turning_up(const Truth& truth, const Vector3d& arm) {
  const Vector3d& w = truth.angular_rate;
  return truth.specific_force + w.cross(w.cross(arm));
}

}  // namespace

IncrementIntegrator::IncrementIntegrator(const motion::Trajectory& trajectory, motion::Stamp from,
                                         const Mounting& mounting)
    : trajectory_(trajectory), mounting_(mounting), last_(trajectory.at(from)) {}

Increments IncrementIntegrator::until(motion::Stamp to) {
  const Vector3d& arm = mounting_.lever_arm_m;
  Vector3d angle = Vector3d::Zero(), velocity = Vector3d::Zero();
  while (last_.at < to) {
    const auto piece = std::min<std::chrono::nanoseconds>(to - last_.at, longest_piece);
    const Truth middle = trajectory_.at(last_.at + piece / 2);
    const Truth next = trajectory_.at(last_.at + piece);
    const double dt = measurement::seconds(piece);
    angle += dt * mean(last_.angular_rate, middle.angular_rate, next.angular_rate);
    velocity +=
        dt * mean(force_but_for_turning_up(last_, arm), force_but_for_turning_up(middle, arm),
                  force_but_for_turning_up(next, arm)) +
        (next.angular_rate - last_.angular_rate).cross(arm);
    last_ = next;
  }
  return {mounting_.to_sensor(angle), mounting_.to_sensor(velocity)};
}

}  // namespace drydock::sensor

#include "tests/estimators/consistency/voyage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drydock::consistency::test {
namespace {

using namespace measurement;

constexpr double dt = 0.01, gravity = 9.80665, earth_m = 6.371e6;
constexpr double swing = 40 * std::numbers::pi / 180, pace = 2 * std::numbers::pi / 40;
constexpr double usual_mps = 2, brake_mps2 = 0.2, brake_for_s = 5, surge_mps = 0.1,
                 surge_pace = 2 * std::numbers::pi / 20;

/// The motion at one time, SI; a dash is a derivative with respect to time.
struct Motion {
  /// `braking_s`: since it began to brake.
  Motion(double t, double braking_s)
      : heading(swing * std::sin(pace * t)),
        turn(swing * pace * std::cos(pace * t)),
        turn_dash(-pace * pace * heading),
        speed(usual_mps - brake_mps2 * std::clamp(braking_s, 0.0, brake_for_s) +
              surge_mps * std::sin(surge_pace * t)),
        speed_dash(surge_mps * surge_pace * std::cos(surge_pace * t) -
                   (braking_s > 0 && braking_s < brake_for_s ? brake_mps2 : 0)),
        current(0.3 * std::sin(heading)) {}

  /// Nomoto's law with 5 m and 25 m2: a hull of 5 m.
  double rudder() const {
    const double bend = (turn_dash * speed - turn * speed_dash) / (speed * speed);
    return -(5 * turn / speed + 25 * bend / speed);
  }
  /// The law of surge with an advance of 0.012 m, a way of 30 m and 20 m2.
  double shaft() const {
    const double through = speed - current;
    return std::sqrt(through * through + 30 * speed_dash + 20 * turn * turn) / 0.012;
  }

  double heading, turn, turn_dash, speed, speed_dash, current;
};

std::vector<Sensor> sensors() {
  std::vector<Sensor> all(devices);
  all[dvl] = {.kind = Kind::dvl, .rate_hz = 5};
  all[log] = {.kind = Kind::emlog, .rate_hz = 2};
  all[gnss] = {.kind = Kind::gnss, .rate_hz = 5};
  all[imu] = {.kind = Kind::imu, .rate_hz = 100};
  all[depth] = {.kind = Kind::depth, .rate_hz = 10};
  all[actuators] = {.kind = Kind::actuator, .rate_hz = 10};
  all[compass] = {.kind = Kind::attitude, .rate_hz = 10};
  return all;
}

}  // namespace

Voyage::Voyage(std::vector<std::uint16_t> with, unsigned seed)
    : has_(devices), random_(seed), checks_(sensors(), signs_) {
  for (const auto device : with) has_[device] = true;
}

void Voyage::run(double end_s, const Fault& fault) {
  for (; static_cast<double>(step_) * dt < end_s; ++step_) tick(fault);
}

void Voyage::tick(const Fault& fault) {
  const double t = static_cast<double>(step_) * dt;
  const Motion motion(t, t - brakes_at_s_);
  const double heading = motion.heading, turn = motion.turn, speed = motion.speed;
  north_ += dt * speed * std::cos(heading);
  east_ += dt * speed * std::sin(heading);
  const auto every = [&](long steps) { return step_ % steps == 0; };

  ImuSample inertial;
  inertial.angular_rate = {noise(1e-4), noise(1e-4), turn + noise(1e-4)};
  inertial.specific_force = {motion.speed_dash + noise(0.01), speed * turn + noise(0.01),
                             -gravity + noise(0.01)};
  give(inertial, imu, fault);
  if (every(20)) {
    BottomVelocity bottom;
    bottom.velocity = Eigen::Vector3d{speed + noise(0.01), noise(0.01), noise(0.01)};
    give(bottom, dvl, fault);
    GnssFix fix;
    fix.velocity_ned = Eigen::Vector3d{speed * std::cos(heading) + noise(0.05),
                                       speed * std::sin(heading) + noise(0.05), noise(0.05)};
    fix.position = Geodetic{(north_ + noise(1)) / earth_m, (east_ + noise(1)) / earth_m};
    give(fix, gnss, fault);
  }
  if (every(50)) {
    WaterSpeed water;
    water.longitudinal_mps = speed - motion.current + noise(0.05);
    water.transverse_mps = -0.3 * std::cos(heading) + noise(0.05);
    give(water, log, fault);
  }
  if (!every(10)) return;
  DepthSample below;
  below.depth_m = 0.5 + noise(0.02);
  give(below, depth, fault);
  ActuatorState state;
  state.rudder_rad = motion.rudder();
  state.propeller_radps = motion.shaft();
  give(state, actuators, fault);
  AttitudeSample attitude;
  attitude.true_heading_rad =
      std::remainder(heading - std::numbers::pi + noise(0.005), 2 * std::numbers::pi) +
      std::numbers::pi;
  attitude.roll_rad = noise(0.005);
  attitude.pitch_rad = noise(0.005);
  attitude.rate_of_turn_radps = turn + noise(0.002);
  give(attitude, compass, fault);
}

void Voyage::give(Measurement measurement, std::uint16_t device, const Fault& fault) {
  const double t = static_cast<double>(step_) * dt;
  std::visit(
      [&](auto& sample) {
        sample.origin.device = device;
        sample.origin.valid_at = Stamp{} + from_seconds(t + 1000);
        sample.origin.received_at = sample.origin.valid_at + std::chrono::milliseconds{20};
      },
      measurement);
  if (fault) fault(measurement, t);
  if (!has_[device]) return;
  checks_.take(measurement);
  if (step_ % 25 == 0) checks_.tell(Stamp{} + from_seconds(t));
}

}  // namespace drydock::consistency::test

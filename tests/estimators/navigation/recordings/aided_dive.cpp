#include "tests/estimators/navigation/recordings/aided_dive.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/local_earth.hpp"

namespace drydock::navigation::test {

using Eigen::Vector3d;

namespace {

constexpr double leveling_s = 2;

template <class Samples>
std::size_t first_after(const Samples& samples, double t) {
  std::size_t i = 0;
  while (i < samples.size() && samples[i].t <= t) ++i;
  return i;
}

struct InnovationMean {
  double square = 0;
  int rows = 0;
  void add(const AidedNavigation& aided) {
    square += aided.innovation_square();
    rows += aided.innovations().size();
  }
  double mean() const { return rows ? square / rows : 0; }
};

}  // namespace

double magnetic_heading(const Vector3d& field_body, const frame::Euler& attitude) {
  const Vector3d level = frame::body_to_ned({attitude.roll, attitude.pitch, 0}) * field_body;
  return std::atan2(-level.y(), level.x());
}

double height_of(const TimedPressure& pressure, const DiveSetup& setup) {
  return -pressure.pascal / setup.density / frame::local_earth(setup.latitude_rad, 0).gravity_mps2;
}

Read<AlignedDive> aligned(const PoolRecording& dive, const DiveSetup& setup) {
  const double begin = dive.imu.front().t + leveling_s;
  AlignedDive at{begin,
                 first_after(dive.imu, begin),
                 first_after(dive.dvl, begin),
                 first_after(dive.pressure, begin),
                 first_after(dive.magnetic, begin),
                 {}};
  if (at.sample == dive.imu.size() || at.ping == dive.dvl.size() ||
      at.pressed == dive.pressure.size() || at.field == dive.magnetic.size())
    return Refusal{"alignment", "the dive is over before it is levelled"};

  Vector3d force = Vector3d::Zero();
  for (std::size_t i = 0; i < at.sample; ++i) force += setup.imu_to_body * dive.imu[i].force;
  frame::Euler attitude{std::atan2(-force.y(), -force.z()),
                        std::atan2(force.x(), std::hypot(force.y(), force.z())), 0};
  attitude.yaw = magnetic_heading(setup.imu_to_body * dive.magnetic[at.field].value, attitude);
  at.state = {{setup.latitude_rad, 0, height_of(dive.pressure[at.pressed], setup)},
              Vector3d::Zero(),
              frame::body_to_ned(attitude)};
  at.state.position.height_m += (at.state.body_to_ned * setup.pressure_lever).z();
  at.state.velocity_ned = at.state.body_to_ned * (setup.dvl_to_body * dive.dvl[at.ping].value);
  return at;
}

Read<DiveResult> navigate(const PoolRecording& dive, const DiveSetup& setup) {
  const auto found = aligned(dive, setup);
  if (found.has_error()) return found.error();
  auto [begin, sample, ping, pressed, field, start] = *found;
  const auto height = [&](const TimedPressure& p) { return height_of(p, setup); };
  AidedNavigation aided{start, setup.options};

  DiveResult result;
  InnovationMean velocity, depth;
  double now = begin, heading = frame::euler(start.body_to_ned).yaw, magnetic = heading;
  double velocity_square = 0, depth_square = 0;
  Vector3d rate = Vector3d::Zero();
  const auto go_to = [&](double t, const ImuRow& imu) {
    const double dt = t - now;
    rate = setup.imu_to_body * imu.rate;
    aided.add_imu(rate * dt, setup.imu_to_body * imu.force * dt, dt);
    aided.step();
    result.travelled_m += aided.state().velocity_ned.head<2>().norm() * dt;
    now = t;
  };
  for (; sample < dive.imu.size(); ++sample) {
    const ImuRow& imu = dive.imu[sample];
    for (; ping < dive.dvl.size() && dive.dvl[ping].t <= imu.t; ++ping) {
      if (dive.dvl[ping].t > now) go_to(dive.dvl[ping].t, imu);
      const Vector3d seen = setup.dvl_to_body * dive.dvl[ping].value;
      const NavigationState& s = aided.state();
      velocity_square += (s.body_to_ned.conjugate() * s.velocity_ned +
                          (rate - aided.gyro_bias()).cross(setup.dvl_lever) - seen)
                             .squaredNorm();
      result.refused +=
          3 - aided.update_velocity(seen, Vector3d::Constant(setup.dvl_sigma_mps), setup.dvl_lever);
      velocity.add(aided);
    }
    for (; pressed < dive.pressure.size() && dive.pressure[pressed].t <= imu.t; ++pressed) {
      if (dive.pressure[pressed].t > now) go_to(dive.pressure[pressed].t, imu);
      const double seen = height(dive.pressure[pressed]);
      const NavigationState& s = aided.state();
      const double sensor = s.position.height_m - (s.body_to_ned * setup.pressure_lever).z();
      depth_square += (sensor - seen) * (sensor - seen);
      result.refused += 1 - aided.update_height(seen, setup.depth_sigma_m, setup.pressure_lever);
      depth.add(aided);
    }
    if (imu.t > now) go_to(imu.t, imu);
    const frame::Euler at = frame::euler(aided.state().body_to_ned);
    result.turned_rad += frame::wrap_pi(at.yaw - heading);
    heading = at.yaw;
    for (; field < dive.magnetic.size() && dive.magnetic[field].t <= imu.t; ++field) {
      const double seen = magnetic_heading(setup.imu_to_body * dive.magnetic[field].value, at);
      result.magnetic_turned_rad += frame::wrap_pi(seen - magnetic);
      magnetic = seen;
    }
  }
  result.gap_m = frame::ned_offset(start.position, aided.state().position).head<2>().norm();
  const auto& p = aided.covariance();
  const double cosine = std::cos(setup.latitude_rad);
  result.gap_sigma_m = 6.37e6 * std::sqrt(p(0, 0) + p(1, 1) * cosine * cosine);
  result.velocity_nis = velocity.mean();
  result.depth_nis = depth.mean();
  result.velocity_rms_mps = std::sqrt(velocity_square / std::max(1, velocity.rows));
  result.depth_rms_m = std::sqrt(depth_square / std::max(1, depth.rows));
  return result;
}

}  // namespace drydock::navigation::test

#include "hil/bench/loop_record.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/attitude.hpp"
#include "estimators/frame/geodetic.hpp"
#include "hil/motion/vehicle/vehicle_trajectory.hpp"
#include "hil/pilot/step_response.hpp"

namespace drydock::bench {

namespace {

constexpr std::chrono::milliseconds period{100};

double speed_through_water(const motion::Truth& truth) {
  return (truth.body_to_ned.conjugate() * (truth.velocity_ned - truth.current_ned)).x();
}

/// The heading that is nearest to the one before it.
void add_heading(double heading_rad, double first_deg, std::vector<double>& to_deg) {
  const double before = (to_deg.empty() ? first_deg : to_deg.back()) * units::degree;
  to_deg.push_back((before + frame::wrap_pi(heading_rad - before)) / units::degree);
}

frame::Position place_of(const motion::Truth& truth) {
  return {truth.latitude_rad, truth.longitude_rad, truth.height_m};
}

void keep_larger(double difference, double& largest) {
  largest = std::max(largest, std::abs(difference));
}

}  // namespace

LoopRecord::LoopRecord(const rig_config::Rig& rig, const motion::Trajectory& truth, Stamp start)
    : mission_(rig.mission),
      truth_(truth),
      in_process_(std::make_unique<motion::VehicleTrajectory>(rig.mission, start)),
      plan_(rig.mission),
      start_(start),
      next_(start) {
  if (!plan_.guidance()) return;
  for (const auto& waypoint : plan_.guidance()->waypoints())
    account_.waypoints.push_back({waypoint.north_m, waypoint.east_m, waypoint.radius_m, {}});
}

void LoopRecord::on_measurement(const measurement::Measurement& m) {
  const Stamp valid_at = measurement::origin_of(m).valid_at;
  if (valid_at < next_) return;
  sample(next_);
  next_ += ((valid_at - next_) / period + 1) * period;
}

void LoopRecord::sample(Stamp at) {
  const double t = measurement::seconds(at - start_);
  const motion::Truth is = truth_.at(at), ideal = in_process_->at(at);
  motion::VehicleState state;
  state.latitude_rad = is.latitude_rad;
  state.longitude_rad = is.longitude_rad;
  follow(state, t);
  const auto plan = plan_.at(t, state, guidance_, std::chrono::duration<double>(period).count());
  auto& trace = account_.trace;
  trace.t_s.push_back(t);
  const double first_deg = mission_.heading_rad / units::degree;
  add_heading(plan.yaw.value, first_deg, trace.heading_deg.wanted);
  add_heading(is.yaw_rad, first_deg, trace.heading_deg.is);
  add_heading(ideal.yaw_rad, first_deg, trace.heading_deg.in_process);
  trace.depth_m.wanted.push_back(plan.depth_m);
  trace.depth_m.is.push_back(-is.height_m);
  trace.depth_m.in_process.push_back(-ideal.height_m);
  trace.speed_mps.wanted.push_back(plan.speed.value);
  trace.speed_mps.is.push_back(speed_through_water(is));
  trace.speed_mps.in_process.push_back(speed_through_water(ideal));
  keep_larger(frame::wrap_pi(is.yaw_rad - ideal.yaw_rad) / units::degree, account_.heading_off_deg);
  keep_larger(is.height_m - ideal.height_m, account_.depth_off_m);
  keep_larger(trace.speed_mps.is.back() - trace.speed_mps.in_process.back(),
              account_.speed_off_mps);
  keep_larger(frame::ned_offset(place_of(ideal), place_of(is)).norm(), account_.place_off_m);
}

/// The cross-track error on the line that the true place is at, and the waypoint that it passes.
void LoopRecord::follow(const motion::VehicleState& state, double t) {
  if (!plan_.guidance() || guidance_.over) return;
  const std::size_t line = guidance_.line;
  const auto& waypoints = plan_.guidance()->waypoints();
  const double cross_m =
      motion::track_errors(motion::place_of(waypoints[line]), motion::place_of(waypoints[line + 1]),
                           plan_.north_east_m(state))
          .cross;
  auto& end = account_.waypoints[line + 1];
  keep_larger(cross_m, end.cross_track_max_m);
  const auto passed = plan_.pass(state, guidance_);
  if (!passed) return;
  end.passed_s = t;
  end.reached = passed->reached;
  end.cross_track_end_m = cross_m;
}

pilot::LoopAccount LoopRecord::account() const {
  pilot::LoopAccount account = account_;
  account.responses = pilot::step_responses(mission_, account.trace);
  return account;
}

}  // namespace drydock::bench

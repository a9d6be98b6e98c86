#include "hil/summary/scribe.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "drivers/measurement/units.hpp"

namespace drydock::summary {

using namespace measurement;

namespace {

frame::Position position_of(const motion::Truth& truth) {
  return {truth.latitude_rad, truth.longitude_rad, truth.height_m};
}

/// Resident memory of this process: the second figure of /proc/self/statm, in pages. 0 if there is
/// no such file.
double resident_megabytes() {
  std::ifstream statm("/proc/self/statm");
  double size = 0, resident = 0;
  statm >> size >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

}  // namespace

Scribe::Scribe(const rig_config::Rig& rig, const motion::Trajectory* truth, Stamp start,
               double expected_duration_s, double points_per_curve)
    : truth_(truth), start_(start), spacing_s_(expected_duration_s / points_per_curve) {
  if (truth) origin_ = position_of(truth->at(start));
  for (const auto& config : rig.estimators) {
    Estimator estimator;
    estimator.summary.name = config.name;
    estimator.summary.kind = rig_config::facts_of(config.kind).name;
    estimator.has_truth = truth != nullptr;
    estimators_.push_back(std::move(estimator));
  }
  for (const auto& device : rig.devices) add_device(device);
}

std::size_t Scribe::add_plot(const rig_config::DeviceConfig& device, const std::string& what,
                             std::string unit, std::vector<std::string> labels) {
  const std::size_t first = curves_.size();
  for (std::size_t i = 0; i < labels.size(); ++i) curves_.push_back({plots_.size(), i, 0});
  MeasurementTrace plot{
      device.name, device.name + ": " + what, std::move(unit), std::move(labels), {}, {}};
  plot.t_s.resize(plot.labels.size());
  plot.value.resize(plot.labels.size());
  plots_.push_back(std::move(plot));
  return first;
}

void Scribe::add_device(const rig_config::DeviceConfig& device) {
  using rig_config::DeviceKind;
  std::size_t first = 0;
  switch (device.kind) {
    case DeviceKind::dvl:
      first =
          add_plot(device, "velocity over the bed", "m/s, body", {"forward", "starboard", "down"});
      break;
    case DeviceKind::emlog:
      first = add_plot(device, "speed through the water", "m/s", {"ahead", "starboard"});
      break;
    case DeviceKind::gnss:
      first = add_plot(device, "velocity", "m/s, NED", {"north", "east", "down"});
      break;
    case DeviceKind::imu:
      first = add_plot(device, "angular rate", "deg/s, body", {"forward", "starboard", "down"});
      add_plot(device, "specific force", "m/s2, body", {"forward", "starboard", "down"});
      break;
    case DeviceKind::depth: first = add_plot(device, "depth", "m", {"depth"}); break;
    case DeviceKind::actuator:
      first = add_plot(device, "actuators", "deg", {"rudder", "stern plane", "bow plane"});
      break;
    case DeviceKind::attitude:
      first = add_plot(device, "attitude", "deg", {"heading", "roll", "pitch"});
      add_plot(device, "rate of turn", "deg/s", {"rate of turn"});
      break;
  }
  first_curve_.push_back(first);
}

void Scribe::point(std::size_t curve, Stamp at, double value) {
  auto& c = curves_[curve];
  const double t = since_start(steady(at));
  if (t < c.next_point_s) return;
  c.next_point_s = t + spacing_s_;
  plots_[c.plot].t_s[c.line].push_back(t);
  plots_[c.plot].value[c.line].push_back(value);
}

void Scribe::on_measurement(const Measurement& m) {
  const Origin& origin = origin_of(m);
  if (origin.device >= first_curve_.size()) return;
  const std::size_t first = first_curve_[origin.device];
  const auto maybe = [&](std::size_t i, const std::optional<double>& value, double scale = 1) {
    if (value) point(first + i, origin.valid_at, *value * scale);
  };
  const auto vector = [&](std::size_t i, const Eigen::Vector3d& v, double scale = 1) {
    for (int k = 0; k < 3; ++k)
      point(first + i + static_cast<std::size_t>(k), origin.valid_at, v[k] * scale);
  };
  if (const auto* imu = std::get_if<ImuSample>(&m)) {
    vector(0, imu->angular_rate, units::degrees_per_radian);
    vector(3, imu->specific_force);
  } else if (const auto* dvl = std::get_if<BottomVelocity>(&m)) {
    if (dvl->velocity) vector(0, *dvl->velocity);
  } else if (const auto* log = std::get_if<WaterSpeed>(&m)) {
    maybe(0, log->longitudinal_mps);
    maybe(1, log->transverse_mps);
  } else if (const auto* fix = std::get_if<GnssFix>(&m)) {
    if (fix->velocity_ned) vector(0, *fix->velocity_ned);
  } else if (const auto* depth = std::get_if<DepthSample>(&m)) {
    maybe(0, depth->depth_m);
  } else if (const auto* actuators = std::get_if<ActuatorState>(&m)) {
    maybe(0, actuators->rudder_rad, units::degrees_per_radian);
    maybe(1, actuators->stern_plane_rad, units::degrees_per_radian);
    maybe(2, actuators->bow_plane_rad, units::degrees_per_radian);
  } else if (const auto* compass = std::get_if<AttitudeSample>(&m)) {
    maybe(0, compass->heading_rad, units::degrees_per_radian);
    maybe(1, compass->roll_rad, units::degrees_per_radian);
    maybe(2, compass->pitch_rad, units::degrees_per_radian);
    maybe(3, compass->rate_of_turn_radps, units::degrees_per_radian);
  }
}

void Scribe::on_estimate(const host::Estimate& estimate) {
  auto& e = estimators_[estimate.estimator];
  e.summary.promised = estimate.integrity;
  std::optional<motion::Truth> truth;
  if (e.has_truth) truth = truth_->at(steady(estimate.attitude.valid_at));
  const motion::Truth* known = truth ? &*truth : nullptr;
  const double t = since_start(steady(estimate.attitude.valid_at));
  const bool draw = is_time_to_draw(e, t);
  compare(e, estimate.attitude, known, draw);
  if (estimate.navigation)
    e.navigation.note(*estimate.navigation, estimate.current, known, t, draw);
}

bool Scribe::is_time_to_draw(Estimator& e, double t_s) const {
  if (t_s < e.next_point_s) return false;
  e.next_point_s = t_s + spacing_s_;
  return true;
}

void Scribe::compare(Estimator& e, const bus::Attitude& estimate, const motion::Truth* truth,
                     bool draw) {
  ++e.summary.estimates;
  e.rate.add(steady(estimate.valid_at));
  const double t = since_start(steady(estimate.valid_at));
  if (draw) {
    e.trace.t_s.push_back(t);
    e.trace.roll_deg.push_back(estimate.roll_rad * units::degrees_per_radian);
    e.trace.pitch_deg.push_back(estimate.pitch_rad * units::degrees_per_radian);
    e.trace.roll_sigma_deg.push_back(std::sqrt(estimate.covariance(0, 0)) *
                                     units::degrees_per_radian);
    e.trace.pitch_sigma_deg.push_back(std::sqrt(estimate.covariance(1, 1)) *
                                      units::degrees_per_radian);
  }
  if (!truth) return;
  e.whole_run.add(estimate, *truth, t);
  if (t >= 10) e.after_10_s.add(estimate, *truth, t);
  if (draw) {
    e.trace.true_roll_deg.push_back(truth->roll_rad * units::degrees_per_radian);
    e.trace.true_pitch_deg.push_back(truth->pitch_rad * units::degrees_per_radian);
  }
}

void Scribe::tick(Stamp now) {
  const double t = since_start(now);
  if (!resident_.t_s.empty() && t < resident_.t_s.back() + 3 * spacing_s_) return;
  resident_.t_s.push_back(t);
  resident_.megabytes.push_back(resident_megabytes());
  if (truth_) follow_motion(now);
}

void Scribe::follow_motion(Stamp now) {
  const auto truth = truth_->at(now);
  const auto offset = frame::ned_offset(*origin_, position_of(truth));
  motion_.t_s.push_back(since_start(now));
  motion_.north_m.push_back(offset.x());
  motion_.east_m.push_back(offset.y());
  motion_.depth_m.push_back(-truth.height_m);
  motion_.speed_mps.push_back(truth.velocity_body.norm());
  motion_.heading_deg.push_back(truth.yaw_rad * units::degrees_per_radian);
}

void Scribe::write(Summary& summary) const {
  for (const auto& e : estimators_) {
    summary.estimators.push_back(e.summary);
    summary.estimators.back().rate_hz = e.rate.hz();
    if (e.whole_run.count() > 0) summary.estimators.back().whole_run = e.whole_run.result();
    if (e.after_10_s.count() > 0) summary.estimators.back().after_10_s = e.after_10_s.result();
    summary.traces.push_back(e.trace);
    summary.estimators.back().navigation = e.navigation.error();
    summary.navigation.push_back(e.navigation.trace());
  }
  summary.measurements = plots_;
  summary.motion = motion_;
  summary.resident = resident_;
}

}  // namespace drydock::summary

#include "hil/track/gatherer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drivers/measurement/axis_sigma.hpp"
#include "drivers/measurement/units.hpp"

namespace drydock::track {
namespace {

using Eigen::Vector3d;
using measurement::FixType;

// First guesses of noise that nobody states; it is fitted.
constexpr double usual_bottom_mps = 0.02, usual_log_mps = 0.05, usual_depth_m = 0.1;
constexpr double usual_heading_rad = 1 * units::degree, usual_fix_m = 2.5;
/// A receiver's height errs about so many times as much as an axis of its position: chosen.
constexpr double usual_height_ratio = 2;
/// A stated accuracy below this is no accuracy.
constexpr double least_sigma = 1e-4;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::optional<Vector3d> sigma_of(const std::optional<Eigen::Matrix3d>& covariance) {
  if (!covariance) return {};
  const Vector3d sigma = covariance->diagonal().cwiseSqrt();
  if (!sigma.allFinite() || sigma.minCoeff() < least_sigma) return {};
  return sigma;
}

std::optional<Vector3d> sigma_of(const measurement::GnssFix& fix) {
  const auto axis = measurement::axis_sigma_m(fix);
  if (!axis || !(*axis >= least_sigma)) return {};
  const double height = fix.vertical_accuracy_m.value_or(0);
  return Vector3d{*axis, *axis, height >= least_sigma ? height : usual_height_ratio * *axis};
}

/// Above the ellipsoid; a fix in two dimensions has none.
double height_of(const measurement::GnssFix& fix) {
  return fix.type == FixType::two_d ? unknown : fix.ellipsoidal_height_m.value_or(unknown);
}

std::optional<Vector3d> sigma_of(const std::optional<double>& sigma) {
  if (!sigma || !(*sigma >= least_sigma)) return {};
  return Vector3d::Constant(*sigma);
}

bool is_position(FixType type) {
  return type == FixType::two_d || type == FixType::three_d || type == FixType::gnss_and_dr;
}

}  // namespace

Gatherer::Gatherer(const rig_config::Rig& rig, std::optional<std::uint16_t> inertial)
    : rig_(rig), inertial_(inertial), attitudes_(rig) {}

double Gatherer::time_of(Stamp at) {
  if (!started_) gathered_.start = at;
  started_ = true;
  return measurement::seconds(at - gathered_.start);
}

void Gatherer::on_measurement(const measurement::Measurement& measurement) {
  std::visit([this](const auto& m) { hear(m); }, measurement);
}

void Gatherer::on_truth(const host::Estimate& truth) {
  if (!truth.navigation) return;
  const auto& n = *truth.navigation;
  gathered_.truth.push_back({time_of(n.valid_at), {n.latitude_rad, n.longitude_rad, n.height_m}});
}

void Gatherer::add(Quantity quantity, const measurement::Origin& origin, const Vector3d& value,
                   const std::optional<Vector3d>& sigma, const Vector3d& usual) {
  gathered_.dive.readings.push_back(
      {time_of(origin.valid_at), quantity, origin.device, value, sigma.value_or(usual)});
  auto& unstated = gathered_.unstated;
  const auto same = [&](const smoothing::UnstatedNoise& one) {
    return one.quantity == quantity && one.device == origin.device;
  };
  if (!sigma && std::ranges::none_of(unstated, same)) unstated.push_back({quantity, origin.device});
}

void Gatherer::add(Quantity quantity, const measurement::Origin& origin, const Vector3d& value,
                   const std::optional<Vector3d>& sigma, double usual) {
  add(quantity, origin, value, sigma, Vector3d::Constant(usual));
}

void Gatherer::hear(const measurement::BottomVelocity& track) {
  if (track.sound_speed_mps)
    gathered_.sound_speed_mps[track.origin.device] = *track.sound_speed_mps;
  gathered_.water[track.origin.device].add(track);
  if (track.velocity && track.velocity->allFinite()) {
    add(Quantity::bottom, track.origin, *track.velocity, sigma_of(track.velocity_covariance),
        usual_bottom_mps);
  } else {
    pass_over("DVL without bottom track");
  }
  if (track.depth_m && std::isfinite(*track.depth_m))
    head_depths_[track.origin.device].push_back({track.origin, *track.depth_m});
  attitudes_.hear(time_of(track.origin.valid_at), track);
}

void Gatherer::hear(const measurement::WaterSpeed& speed) {
  const Vector3d value{speed.longitudinal_mps.value_or(unknown),
                       speed.transverse_mps.value_or(unknown), unknown};
  if (!std::isfinite(value.x())) return pass_over("log without speed");
  add(Quantity::log, speed.origin, value, sigma_of(speed.sigma_mps), usual_log_mps);
}

void Gatherer::hear(const measurement::DepthSample& sample) {
  if (!sample.depth_m || !std::isfinite(*sample.depth_m))
    return pass_over("depth sensor without depth");
  add(Quantity::depth, sample.origin, {*sample.depth_m, 0, 0}, {}, usual_depth_m);
}

void Gatherer::hear(const measurement::AttitudeSample& sample) {
  attitudes_.hear(time_of(sample.origin.valid_at), sample);
  if (sample.true_heading_rad && std::isfinite(*sample.true_heading_rad))
    return add(Quantity::heading, sample.origin, {*sample.true_heading_rad, 0, 0}, {},
               usual_heading_rad);
  if (sample.heading_rad) pass_over("magnetic heading without variation");
}

void Gatherer::hear(const measurement::GnssFix& fix) {
  if (fix.utc && !utc_ahead_) utc_ahead_ = *fix.utc - fix.origin.valid_at;
  if (!fix.position || !is_position(fix.type)) return pass_over("GNSS without fix");
  add(Quantity::fix, fix.origin,
      {fix.position->latitude_rad, fix.position->longitude_rad, height_of(fix)}, sigma_of(fix),
      Vector3d{usual_fix_m, usual_fix_m, usual_height_ratio * usual_fix_m});
}

void Gatherer::hear(const measurement::ImuSample& sample) {
  if (inertial_ != sample.origin.device) return;
  if (!sample.angular_rate.allFinite() || !sample.specific_force.allFinite())
    return pass_over("IMU sample that is no number");
  gathered_.dive.inertial.push_back(
      {time_of(sample.origin.valid_at), sample.angular_rate, sample.specific_force});
}

/// The heading of a head counts only where no compass told one.
void Gatherer::take_attitudes() {
  auto tilts = attitudes_.tilts();
  gathered_.own_tilts = tilts.of_dvl;
  if (std::ranges::find(gathered_.dive.readings, Quantity::heading,
                        &smoothing::Reading::quantity) == gathered_.dive.readings.end())
    for (const auto& heading : attitudes_.of_heads(tilts.all)) {
      gathered_.own_heading = true;
      add(Quantity::heading, heading.origin, {heading.rad, 0, 0}, {}, usual_heading_rad);
    }
  gathered_.dive.tilts = std::move(tilts.all);
}

/// The depth of a head counts only where no depth sensor spoke. One that never changes is a setting
/// of the head.
void Gatherer::take_own_depths() {
  if (std::ranges::find(gathered_.dive.readings, Quantity::depth, &smoothing::Reading::quantity) !=
      gathered_.dive.readings.end())
    return;
  for (const auto& [device, depths] : head_depths_) {
    const auto [least, most] = std::ranges::minmax(depths, {}, &HeadDepth::m);
    if (!(least.m < most.m)) continue;
    gathered_.own_depth = true;
    for (const auto& depth : depths)
      add(Quantity::depth, depth.origin, {depth.m, 0, 0}, {}, usual_depth_m);
  }
}

Gathered Gatherer::take() {
  take_attitudes();
  take_own_depths();
  auto& dive = gathered_.dive;
  std::ranges::stable_sort(dive.readings, {}, &smoothing::Reading::time_s);
  std::ranges::stable_sort(dive.inertial, {}, &smoothing::InertialReading::time_s);
  std::ranges::stable_sort(gathered_.truth, {}, &TruthPoint::time_s);
  gathered_.rig = rig_;
  gathered_.utc = gathered_.start;
  if (utc_of_receiver_ && utc_ahead_) gathered_.utc += *utc_ahead_;
  return std::move(gathered_);
}

}  // namespace drydock::track

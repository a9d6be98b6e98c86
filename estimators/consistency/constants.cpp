#include "estimators/consistency/constants.hpp"

#include <cmath>

#include "drivers/measurement/units.hpp"

namespace drydock::consistency {
namespace {

using diagnosis::Sign;

using units::degree;
/// Of a DVL's vertical velocity and of a depth sensor that drifts; it looks like a pitch at one
/// speed.
constexpr double bias_mps = 0.01;
/// 1 sigma of sound vehicles. Wider ones would explain the noise of the first windows.
constexpr double usual_pitch = 0.05, usual_tilt = 0.1;
constexpr double vertical_noise_mps = 0.01, speed_noise_mps = 0.02;
/// What the fits tell at least: leveling and mounting of a sound vehicle are better.
constexpr double least_pitch = 2 * degree, least_tilt = 0.5, least_scale = 0.03;
constexpr double memory = 0.98;                // a window
constexpr double sure = 6;                     // sigmas
constexpr double fewest = 12;                  // windows
constexpr double slowest_for_scale_mps = 0.5;  // below it noise looks like speed

/// What is below two sigmas is noise of the first windows: of that nothing is taken off, of more
/// nearly all (the positive part of James and Stein's estimate).
double without_noise(double value, double sigma) {
  constexpr double noise = 2;  // sigmas
  const double share = noise * sigma / value;
  return std::abs(share) < 1 ? value * (1 - share * share) : 0;
}

bool is_told(double value, double sigma, double least) {
  return std::abs(value) > std::max(least, sure * sigma);
}

}  // namespace

Constants::Constants(const Tracks& tracks) : tracks_(tracks) {
  std::size_t place = 0;
  for (const auto& dvl : tracks.dvls)
    dvls_.push_back({.device = dvl.device,
                     .track = place++,
                     .vertical{{bias_mps, usual_pitch, usual_tilt}, vertical_noise_mps, memory},
                     .scale{ConstantFit<1>::Vector{1}, speed_noise_mps, memory}});
}

/// A window without gaps.
void Constants::step(Dvl& dvl, const Moment& moment, const std::optional<Depth>& depth,
                     std::optional<double> speed_mps) {
  const auto& track = tracks_.dvls[dvl.track];
  const auto read = track.velocity.at(moment.at);
  const auto own = track.down.at(moment.at);
  if (!read || (!moment.down && !own)) {
    dvl.begun.reset();
    return;
  }
  const Eigen::Vector3d down = moment.down ? *moment.down : own->value;
  const Eigen::Vector3d velocity = at_origin(read->value, track.sensor.lever_arm_m, moment);
  const double down_mps = velocity.dot(down);
  if (!dvl.begun) {
    dvl.begun = moment.at;
    if (dvl.first == Stamp{}) dvl.first = moment.at;
    dvl.sums = {.begun_mps = down_mps,
                .depth_m = depth.value_or(Depth{}).m,
                .deep = depth.has_value(),
                .fixed = true};
    return;
  }
  Sums& sums = dvl.sums;
  sums.down_m += moment.dt * down_mps;
  sums.last_mps = down_mps;
  sums.terms_s += moment.dt * terms(velocity, down);
  sums.over_ground_m += moment.dt * levelled(velocity, moment).norm();
  sums.receiver_m += moment.dt * speed_mps.value_or(0);
  sums.fixed = sums.fixed && speed_mps;
  sums.deep = sums.deep && depth;
  sums.last = moment.at;
  if (moment.at - *dvl.begun >= window) end(dvl, depth.value_or(Depth{}));
}

void Constants::end(Dvl& dvl, const Depth& depth) const {
  const Sums& sums = dvl.sums;
  const double seconds = measurement::seconds(sums.last - *dvl.begun);
  if (sums.deep) {
    dvl.vertical.add((depth.m - sums.depth_m - sums.down_m) / seconds, sums.terms_s / seconds,
                     depth.late_s * std::hypot(sums.begun_mps, sums.last_mps) / seconds);
    const auto& fit = dvl.constant = dvl.vertical.solve();
    for (int k = 0; k < 3; ++k) dvl.known[k] = without_noise(fit.value[k], fit.sigma(k));
    dvl.tilts_told = dvl.tilts_told ? std::abs(fit.value[2]) > least_tilt / 2
                                    : dvl.vertical.count() > fewest &&
                                          is_told(fit.value[2], fit.sigma(2), least_tilt);
  }
  if (sums.fixed && sums.over_ground_m > slowest_for_scale_mps * seconds) {
    dvl.scale.add((sums.receiver_m - sums.over_ground_m) / seconds,
                  ConstantFit<1>::Vector{sums.over_ground_m / seconds});
    dvl.factor = dvl.scale.solve();
  }
  dvl.begun.reset();
}

void Constants::tell(Stamp now, diagnosis::SymptomSink& to, bool scales) const {
  for (const Dvl& dvl : dvls_) {
    diagnosis::Symptom sign;
    sign.device = dvl.device, sign.since = dvl.first, sign.at = now;
    const auto say = [&](Sign kind, double value, double limit, std::string_view quantity,
                         std::string_view unit) {
      sign.sign = kind, sign.value = value, sign.limit = std::copysign(limit, value);
      sign.quantity = quantity, sign.unit = unit;
      to.see(sign);
    };
    const auto& constant = dvl.constant;
    if (dvl.tilts_told)
      say(Sign::rotated, 100 * constant.value[2], 100 * least_tilt,
          "share of the tilts used wrongly", "%");
    else if (dvl.vertical.count() > fewest &&
             is_told(constant.value[1], constant.sigma(1), least_pitch))
      say(Sign::rotated, constant.value[1] / degree, least_pitch / degree,
          "pitch against the depth", "deg");
    const auto& factor = dvl.factor;
    if (scales && dvl.scale.count() > fewest &&
        is_told(factor.value[0], factor.sigma(0), least_scale))
      say(Sign::scale, -100 * factor.value[0], 100 * least_scale, "speed error against GNSS", "%");
  }
}

}  // namespace drydock::consistency

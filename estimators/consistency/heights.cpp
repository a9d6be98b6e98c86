#include "estimators/consistency/heights.hpp"

#include <cmath>

#include "drivers/measurement/units.hpp"

namespace drydock::consistency {
namespace {

constexpr TestFacts depth_facts{.floor = 0.08,
                                .wander = 0.005,
                                .others_wander = 0.06,
                                .late_s = 0.1,
                                .quantity = "depth",
                                .unit = "m"};
constexpr TestFacts sum_facts{.floor = 0.08,
                              .wander = 0.03,
                              .trend = 0.03,
                              .late_s = 0.1,
                              .sum_above = 0,
                              .excused_by_kin = true,
                              .quantity = "integrated velocity down",
                              .unit = "m"};
/// 1 sigma of roll and pitch that no device tells: a diving vehicle.
constexpr double unknown_tilt_rad = 0.5;
/// 1 sigma of the level's slow error. The way ahead has a part down by it, which adds up for as
/// long as an offset takes to follow.
constexpr double usual_tilt_rad = 0.1 * units::degree, follows_in_s = 10;

}  // namespace

Heights::Heights(const Tracks& tracks, const Constants& constants)
    : tracks_(tracks), constants_(constants) {
  for (const auto& depth : tracks.depths)
    depths_.push_back(group_.add({depth.device}, depth_facts, &depth.depth.freeze()));
  for (const auto& dvl : tracks.dvls)
    dvls_.push_back(group_.add({dvl.device}, sum_facts, &dvl.velocity.freeze(), true));
  sums_.resize(dvls_.size());
}

void Heights::see(const Moment& moment) {
  for (std::size_t i = 0; i < depths_.size(); ++i) {
    const auto& depth = tracks_.depths[i];
    const auto read = depth.depth.at(moment.at);
    if (!read) continue;
    const double below = moment.down ? moment.down->dot(depth.sensor.lever_arm_m) : 0;
    const double unknown_m =
        moment.down ? 0 : unknown_tilt_rad * depth.sensor.lever_arm_m.head<2>().norm();
    group_.see(depths_[i], read->value.x() - below, read->serial, unknown_m);
  }
  see_dvls(moment);
}

/// Without a direction of gravity the DVL cannot say what is down. Half a sample may be missing
/// where the velocity changes.
void Heights::see_dvls(const Moment& moment) {
  for (std::size_t i = 0; i < dvls_.size(); ++i) {
    const auto& dvl = tracks_.dvls[i];
    const auto read = dvl.velocity.at(moment.at);
    const auto own = dvl.down.at(moment.at);
    if (!read || (!moment.down && !own)) continue;
    const Eigen::Vector3d down = moment.down ? *moment.down : own->value;
    const Eigen::Vector3d velocity = at_origin(read->value, dvl.sensor.lever_arm_m, moment);
    const double now_mps = velocity.dot(down) + constants_.missing_down(i, velocity, down);
    if (measurement::seconds(moment.at - sums_[i].last) > 1.5 * moment.dt)
      group_.restart(dvls_[i]);
    else
      sums_[i].depth_m += moment.dt * (now_mps + sums_[i].last_mps) / 2;
    sums_[i].last = moment.at;
    sums_[i].last_mps = now_mps;
    const double tilt_rad = std::hypot(usual_tilt_rad, moment.level_sigma_rad);
    group_.see(dvls_[i], sums_[i].depth_m, read->serial,
               std::hypot(now_mps / (2 * dvl.sensor.rate_hz),
                          follows_in_s * tilt_rad * velocity.cross(down).norm()));
  }
}

}  // namespace drydock::consistency

#include "estimators/consistency/dives.hpp"

#include <numeric>

namespace drydock::consistency {

using diagnosis::Antenna;

Dives::Dives(const Tracks& tracks, const Constants& constants)
    : tracks_(tracks), constants_(constants) {
  for (std::size_t i = 0; i < tracks.receivers.size(); ++i) receivers_.push_back({.track = i});
}

std::optional<double> Dives::velocity_down(std::size_t dvl, const Moment& moment) const {
  const DvlTracks& track = tracks_.dvls[dvl];
  const auto read = track.velocity.at(moment.at);
  const auto own = track.down.at(moment.at);
  if (!read || (!moment.down && !own)) return {};
  const Eigen::Vector3d down = moment.down ? *moment.down : own->value;
  const Eigen::Vector3d velocity = at_origin(read->value, track.sensor.lever_arm_m, moment);
  return velocity.dot(down) + constants_.missing_down(dvl, velocity, down);
}

void Dives::go_on(std::optional<double> down_mps, double dt) {
  if (!down_mps) {
    known_ = 0;
    return;
  }
  depth_m_ += *down_mps * dt;
  depths_m_[known_++ % depths_m_.size()] = depth_m_;
}

std::optional<double> Dives::mean_depth_m() const {
  if (known_ < depths_m_.size()) return {};
  return std::accumulate(depths_m_.begin(), depths_m_.end(), 0.0) /
         static_cast<double>(depths_m_.size());
}

/// A way down that was not known all the time tells nothing.
void Dives::follow(Receiver& receiver, const Moment& moment) const {
  const GnssTracks& track = tracks_.receivers[receiver.track];
  const auto depth_m = mean_depth_m();
  if (track.place.at(moment.at)) {
    receiver = {.track = receiver.track, .before_m = depth_m};
    return;
  }
  receiver.without_fix_s += moment.dt;
  if (track.speed_mps > no_diver_mps) receiver.antenna = Antenna::dry;
  if (!depth_m) receiver.before_m.reset();
  const double later_s = receiver.without_fix_s - patience_s;
  if (!receiver.before_m || later_s < 0 || receiver.antenna == Antenna::wet) return;
  const bool deep = *depth_m - *receiver.before_m > deep_m + wander_mps * later_s;
  receiver.antenna = deep ? Antenna::wet : Antenna::dry;
}

Antenna Dives::antenna(std::uint16_t receiver) const {
  for (const Receiver& one : receivers_)
    if (tracks_.receivers[one.track].device == receiver) return one.antenna;
  return Antenna::unknown;
}

}  // namespace drydock::consistency

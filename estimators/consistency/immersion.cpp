#include "estimators/consistency/immersion.hpp"

namespace drydock::consistency {

Immersion::Immersion(const Tracks& tracks) : tracks_(tracks) {
  for (std::size_t i = 0; i < tracks.depths.size(); ++i) depths_.push_back({.track = i});
}

/// Empty: there is no fix now, or the receiver repeats its last one.
std::optional<double> Immersion::antenna_depth_m(const Depth& depth, const GnssTracks& receiver,
                                                 const Moment& moment) const {
  const DepthTracks& track = tracks_.depths[depth.track];
  const auto read = track.depth.at(moment.at);
  if (!read || !receiver.place.at(moment.at) || receiver.place.freeze().since()) return {};
  const Eigen::Vector3d down = moment.down.value_or(Eigen::Vector3d::UnitZ());
  return read->value.x() + down.dot(receiver.sensor.lever_arm_m - track.sensor.lever_arm_m);
}

/// A dive in which the fix is lost says nothing.
void Immersion::note(Depth& depth, std::optional<double> antenna_m, const Moment& moment) {
  if (!antenna_m) return;
  if (*antenna_m < deepest_m) {
    depth.wet_s = 0;
    return;
  }
  if (depth.wet_s == 0) depth.since = moment.at;
  depth.wet_s += moment.dt;
  depth.antenna_m = *antenna_m;
}

void Immersion::tell(Stamp now, diagnosis::SymptomSink& to) const {
  for (const Depth& depth : depths_) {
    if (depth.wet_s < patience_s) continue;
    to.see({.device = tracks_.depths[depth.track].device,
            .sign = diagnosis::Sign::offset,
            .since = depth.since,
            .at = now,
            .value = depth.antenna_m,
            .limit = deepest_m,
            .quantity = "depth of an antenna that has a fix",
            .unit = "m",
            .advice = "set its zero at the surface; a fix without an antenna in the air would be "
                      "the other reason, and a receiver under water has none"});
  }
}

}  // namespace drydock::consistency

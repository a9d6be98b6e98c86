#include "estimators/consistency/steering.hpp"

#include "drivers/measurement/units.hpp"

namespace drydock::consistency {
namespace {

constexpr TestFacts rudder_facts{.floor = 0.5 * units::degree,
                                 .wander = 0.01 * units::degree,
                                 .late_s = 0.3,
                                 .quantity = "rudder",
                                 .unit = "deg",
                                 .unit_si = units::degree};

constexpr double slowest_steered_mps = 0.5;

}  // namespace

Steering::Steering(const Tracks& tracks) : tracks_(tracks) {
  for (const auto& actuator : tracks.actuators)
    rudders_.push_back({.device = actuator.device,
                        .freeze = &actuator.rudder.freeze(),
                        .test = Test(rudder_facts)});
}

void Steering::step(const Moment& moment, std::optional<double> speed_mps) {
  if (!moment.rate || !moment.down || !speed_mps || *speed_mps < slowest_steered_mps ||
      !is_upright(moment)) {
    for (Rudder& rudder : rudders_) rudder.helm.interrupt();
    return;
  }
  const double curvature = moment.rate->dot(*moment.down) / *speed_mps;
  for (std::size_t i = 0; i < rudders_.size(); ++i) {
    const auto read =
        tracks_.actuators[i].rudder.at(moment.at - measurement::from_seconds(moment.dt / 2));
    if (!read) {
      rudders_[i].helm.interrupt();
      continue;
    }
    rudders_[i].helm.take(read->value.x(), curvature, *speed_mps, moment.dt);
    if (read->serial == rudders_[i].serial) continue;
    rudders_[i].serial = read->serial;
    step(rudders_[i], moment);
  }
}

void Steering::step(Rudder& rudder, const Moment& moment) {
  if (const auto answer = rudder.helm.answer()) {
    const double needed = answer->needed_rad;
    rudder.test.take({.value = answer->rudder_rad - needed,
                      .rate = (needed - rudder.last) / moment.dt,
                      .quantity = needed,
                      .sigma = answer->sigma_rad},
                     moment.at);
    rudder.last = needed;
  }
  if (rudder.test.suspicion() < 0.3) rudder.helm.learn();
}

}  // namespace drydock::consistency

#include "estimators/consistency/steering.hpp"

#include <algorithm>

#include "drivers/measurement/units.hpp"
#include "estimators/consistency/two_laws.hpp"

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

void Steering::step(const Moment& moment, std::optional<double> speed_mps,
                    std::optional<double> through_water_mps) {
  if (!moment.rate || !moment.down || !speed_mps || *speed_mps < slowest_steered_mps ||
      !is_upright(moment)) {
    for (Rudder& rudder : rudders_) rudder.interrupt();
    return;
  }
  const double turn = moment.rate->dot(*moment.down);
  const double water_mps = std::max(through_water_mps.value_or(*speed_mps), slowest_steered_mps);
  for (std::size_t i = 0; i < rudders_.size(); ++i) {
    Rudder& rudder = rudders_[i];
    const auto read =
        tracks_.actuators[i].rudder.at(moment.at - measurement::from_seconds(moment.dt / 2));
    if (!read) {
      rudder.interrupt();
      continue;
    }
    rudder.over_ground.take(read->value.x(), turn / *speed_mps, *speed_mps, moment.dt);
    rudder.through_water.take(read->value.x(), turn / water_mps, water_mps, moment.dt);
    if (read->serial == rudder.serial) continue;
    rudder.serial = read->serial;
    step(rudder, moment);
  }
}

void Steering::step(Rudder& rudder, const Moment& moment) {
  const auto ground = rudder.over_ground.answer(), water = rudder.through_water.answer();
  if (ground && water) {
    const Likely needed =
        mixed({ground->needed_rad, ground->sigma_rad}, {water->needed_rad, water->sigma_rad},
              share_of_second(rudder.over_ground.misfit(), rudder.through_water.misfit()));
    rudder.test.take({.value = ground->rudder_rad - needed.value,
                      .rate = (needed.value - rudder.last) / moment.dt,
                      .quantity = needed.value,
                      .sigma = needed.sigma},
                     moment.at);
    rudder.last = needed.value;
  }
  if (rudder.test.suspicion() >= 0.3) return;
  rudder.over_ground.learn();
  rudder.through_water.learn();
}

}  // namespace drydock::consistency

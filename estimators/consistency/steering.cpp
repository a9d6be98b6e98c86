#include "estimators/consistency/steering.hpp"

#include <algorithm>

#include "drivers/measurement/units.hpp"
#include "estimators/consistency/two_laws.hpp"

namespace drydock::consistency {
namespace {

constexpr TestFacts rudder_facts{.floor = 0.5 * units::degree,
                                 .wander = 0.03 * units::degree,
                                 .late_s = 0.3,
                                 .quantity = "rudder",
                                 .unit = "deg",
                                 .unit_si = units::degree};

constexpr double slowest_steered_mps = 0.5;
/// A hull keeps its speed for longer than its turn: the noise of a speed is not that of a
/// curvature.
constexpr double speed_filter_s = 2;

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
    ground_mps_ = water_mps_ = 0;
    return;
  }
  const double turn = moment.rate->dot(*moment.down);
  const double share = ground_mps_ > 0 ? moment.dt / (speed_filter_s + moment.dt) : 1;
  ground_mps_ += share * (*speed_mps - ground_mps_);
  water_mps_ +=
      share * (std::max(through_water_mps.value_or(*speed_mps), slowest_steered_mps) - water_mps_);
  for (std::size_t i = 0; i < rudders_.size(); ++i) {
    Rudder& rudder = rudders_[i];
    const auto read =
        tracks_.actuators[i].rudder.at(moment.at - measurement::from_seconds(moment.dt / 2));
    if (!read) {
      rudder.interrupt();
      continue;
    }
    rudder.over_ground.take(read->value.x(), turn / ground_mps_, ground_mps_, moment.dt);
    rudder.through_water.take(read->value.x(), turn / water_mps_, water_mps_, moment.dt);
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
  if (rudder.test.fired()) return;
  rudder.over_ground.note_wrong();
  rudder.through_water.note_wrong();
  if (rudder.test.suspicion() >= 0.3) return;
  rudder.over_ground.learn();
  rudder.through_water.learn();
}

}  // namespace drydock::consistency

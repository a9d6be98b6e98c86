#include "estimators/consistency/steering.hpp"

#include "drivers/measurement/units.hpp"

namespace drydock::consistency {
namespace {

constexpr TestFacts rudder_facts{.floor = 0.5 * units::degree,
                                 .wander = 0.01 * units::degree,
                                 .late_s = 1.2,  // a hull turns later than its rudder
                                 .quantity = "rudder",
                                 .unit = "deg",
                                 .unit_si = units::degree};

constexpr double slowest_steered_mps = 0.5;
constexpr double steering_memory_s = 300;
/// The ratio is known after ten seconds of a curve of 100 m radius, or what is as much.
constexpr double enough = 10 * 0.01 * 0.01;
/// The ratio itself differs between manoeuvres by so much.
constexpr double ratio_sigma = 0.1;

}  // namespace

Steering::Steering(const Tracks& tracks) : tracks_(tracks) {
  for (const auto& actuator : tracks.actuators)
    rudders_.push_back({.device = actuator.device,
                        .freeze = &actuator.rudder.freeze(),
                        .test = Test(rudder_facts)});
}

void Steering::step(const Moment& moment, std::optional<double> speed_mps) {
  if (!moment.rate || !moment.down || !speed_mps || *speed_mps < slowest_steered_mps ||
      !is_upright(moment))
    return;
  const double curvature = moment.rate->dot(*moment.down) / *speed_mps;
  for (std::size_t i = 0; i < rudders_.size(); ++i) {
    const auto read =
        tracks_.actuators[i].rudder.at(moment.at - measurement::from_seconds(moment.dt / 2));
    if (!read || read->serial == rudders_[i].serial) continue;
    rudders_[i].serial = read->serial;
    step(rudders_[i], read->value.x(), curvature, moment);
  }
}

void Steering::step(Rudder& rudder, double angle, double curvature_1pm, const Moment& moment) {
  if (rudder.test.suspicion() < 0.3) {
    const double keep = 1 - moment.dt / steering_memory_s;
    const double own = angle - (rudder.test.learned() ? rudder.test.offset() : 0);
    rudder.product = keep * rudder.product + moment.dt * curvature_1pm * own;
    rudder.square = keep * rudder.square + moment.dt * curvature_1pm * curvature_1pm;
  }
  if (rudder.square < enough) return;
  const double needed = rudder.product / rudder.square * curvature_1pm;
  rudder.test.take({.value = angle - needed,
                    .rate = (needed - rudder.last) / moment.dt,
                    .quantity = needed,
                    .sigma = ratio_sigma * std::abs(needed)},
                   moment.at);
  rudder.last = needed;
}

}  // namespace drydock::consistency

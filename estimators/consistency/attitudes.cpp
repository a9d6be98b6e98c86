#include "estimators/consistency/attitudes.hpp"

#include <cmath>

#include "drivers/measurement/units.hpp"

namespace drydock::consistency {
namespace {

TestFacts facts_of_angle(std::string_view quantity) {
  return {.floor = 0.5 * units::degree,
          .wander = 0.02 * units::degree,
          .late_s = 0.1,
          .quantity = quantity,
          .unit = "deg",
          .unit_si = units::degree};
}

constexpr TestFacts turn_facts{.floor = 0.2 * units::degree,
                               .wander = 0.01 * units::degree,
                               .late_s = 0.2,
                               .quantity = "rate of turn",
                               .unit = "deg/s",
                               .unit_si = units::degree};

}  // namespace

Attitudes::Attitudes(const Tracks& tracks) : tracks_(tracks) {
  for (const auto& compass : tracks.compasses)
    compasses_.push_back(
        {.device = compass.device,
         .tilt_freeze = &compass.tilt.freeze(),
         .turn_freeze = &compass.turn.freeze(),
         .tests{Test(facts_of_angle("roll")), Test(facts_of_angle("pitch")), Test(turn_facts)}});
}

void Attitudes::step(const Moment& moment) {
  if (!moment.down || !moment.rate) return;
  for (std::size_t i = 0; i < compasses_.size(); ++i)
    step(compasses_[i], tracks_.compasses[i], moment);
  last_turn_ = moment.rate->dot(*moment.down);
}

void Attitudes::step(Compass& compass, const AttitudeTracks& tracks, const Moment& moment) {
  const Eigen::Vector3d& down = *moment.down;
  const double roll = std::atan2(down.y(), down.z());
  const double pitch = std::asin(std::clamp(-down.x(), -1.0, 1.0));
  if (const auto tilt = tracks.tilt.at(moment.at); tilt && tilt->serial != compass.tilt_serial) {
    compass.tilt_serial = tilt->serial;
    compass.tests[0].take(
        {.value = tilt->value[0] - roll, .rate = moment.rate->x(), .sigma = moment.level_sigma_rad},
        moment.at);
    compass.tests[1].take({.value = tilt->value[1] - pitch,
                           .rate = moment.rate->y(),
                           .sigma = moment.level_sigma_rad},
                          moment.at);
  }
  // The unit's rate is the mean of the last step.
  const auto turn = tracks.turn.at(moment.at - measurement::from_seconds(moment.dt / 2));
  if (!turn || turn->serial == compass.turn_serial || moment.dt <= 0) return;
  compass.turn_serial = turn->serial;
  const double now = moment.rate->dot(down);
  compass.tests[2].take({.value = turn->value.x() - now, .rate = (now - last_turn_) / moment.dt},
                        moment.at);
}

}  // namespace drydock::consistency

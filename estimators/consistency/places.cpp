#include "estimators/consistency/places.hpp"

namespace drydock::consistency {
namespace {

constexpr TestFacts north_facts{
    .floor = 2, .wander = 0.1, .late_s = 0.1, .quantity = "position north", .unit = "m"};
constexpr TestFacts east_facts{
    .floor = 2, .wander = 0.1, .late_s = 0.1, .quantity = "position east", .unit = "m"};

}  // namespace

Places::Places(const Tracks& tracks) : tracks_(tracks) {
  for (const auto& one : tracks.receivers)
    receivers_.push_back({.device = one.device,
                          .freeze = &one.place.freeze(),
                          .tests{Test(north_facts), Test(east_facts)}});
}

void Places::step(const Moment& moment) {
  for (std::size_t i = 0; i < receivers_.size(); ++i)
    step(receivers_[i], tracks_.receivers[i], moment);
}

void Places::step(Receiver& receiver, const GnssTracks& tracks, const Moment& moment) {
  const auto velocity = tracks.velocity.at(moment.at);
  const auto place = tracks.place.at(moment.at);
  if (!velocity || !place) return;
  if (measurement::seconds(moment.at - receiver.last) > 1.5 * moment.dt)
    for (Test& test : receiver.tests) test.restart();
  receiver.travelled += moment.dt / 2 * (velocity->value + receiver.last_velocity);
  receiver.last_velocity = velocity->value;
  receiver.last = moment.at;
  if (place->serial == receiver.serial) return;
  receiver.serial = place->serial;
  for (int axis = 0; axis < 2; ++axis)
    receiver.tests.at(static_cast<std::size_t>(axis))
        .take({.value = place->value[axis] - receiver.travelled[axis],
               .rate = velocity->value[axis],
               .quantity = 0,
               .sigma = 0},
              moment.at);
}

}  // namespace drydock::consistency

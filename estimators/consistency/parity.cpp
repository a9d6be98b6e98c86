#include "estimators/consistency/parity.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::consistency {
namespace {

constexpr double quiet_below = 0.3;
/// A jump counts from so many usual changes on, if it is so much larger (log) than the other's.
constexpr double clear_surprise = 5, clear_ratio = 0.7;

bool is_named(const Parity::Names& names, const Devices& devices) {
  return std::ranges::any_of(names,
                             [&](const Named& one) { return contains(devices, one.device); });
}

/// Of two fired tests of one device, whether the first says more about the kind of its fault.
bool clearer(const Accusation& one, const Accusation& other) {
  if (one.secondary != other.secondary) return other.secondary;
  return one.test->fit() > other.test->fit();
}

/// How well one device explains the tests: those that fire with it, less those that are quiet.
/// Where that does not tell, the one whose own samples stopped or jumped at that time.
struct Explains {
  double fired = 0;
  int quiet = 0;
  bool frozen = false;
  double surprise = 0;
  bool operator<(const Explains& other) const {
    if (fired != other.fired) return fired < other.fired;
    if (frozen != other.frozen) return other.frozen;
    if (std::max(surprise, other.surprise) > clear_surprise &&
        std::abs(std::log((surprise + 1) / (other.surprise + 1))) > clear_ratio)
      return surprise < other.surprise;
    return quiet > other.quiet;
  }
};

void add_history(Explains& sum, const Accusation& own, Stamp since) {
  if (own.freeze == nullptr) return;
  const auto still = own.freeze->since();
  sum.frozen = sum.frozen || (still && *still < since + std::chrono::seconds{1});
  sum.surprise = std::max(sum.surprise, own.freeze->surprise(since));
}

/// One of the devices is guilty by other evidence, which has told it already.
bool is_explained(const Accusation& accusation, const Doubts& doubts) {
  return std::ranges::any_of(accusation.devices,
                             [&](std::uint16_t device) { return doubts.is_guilty(device); });
}

/// A test that another device explains says nothing of this one.
Explains explains(std::uint16_t device, const Accusations& accusations, const Doubts& doubts,
                  Stamp since) {
  Explains sum;
  for (const Accusation& one : accusations) {
    if (!contains(one.devices, device) || is_explained(one, doubts)) continue;
    if (one.test->suspicion() < quiet_below) {
      ++sum.quiet;
      continue;
    }
    sum.fired += one.test->suspicion() < 1 ? 0.5 : 1;
    if (one.devices.front() == device) add_history(sum, one, since);
  }
  return sum;
}

/// The device of a fired test that explains most; `alone`: better than the others.
Named best_of(const Accusation& fired, const Accusations& accusations, const Doubts& doubts) {
  Named best{.device = fired.devices.front(), .by = &fired};
  Explains most = explains(best.device, accusations, doubts, fired.test->since());
  for (const auto device : fired.devices) {
    if (device == best.device) continue;
    const Explains its = explains(device, accusations, doubts, fired.test->since());
    best.alone = most < its || its < most;
    if (!(most < its)) continue;
    most = its;
    best.device = device;
  }
  return best;
}

}  // namespace

/// A name does not change while its test fires: the others have reacted to it.
Named Parity::held(const Accusation& fired, Named named) {
  const auto known = std::ranges::find(held_, fired.test, &Held::test);
  if (known != held_.end())
    named.device = known->device;
  else if (held_.size() < held_.capacity())
    held_.push_back({fired.test, named.device});
  return named;
}

Parity::Names Parity::name(const Accusations& accusations, const Doubts& doubts, Stamp now) {
  Names names;
  const auto add = [&](const Named& one) {
    if (names.size() < names.capacity()) names.push_back(one);
  };
  for (const Accusation& one : accusations) {
    if (!one.test->fired() || one.devices.size() != 1) continue;
    const auto known = std::ranges::find(names, one.devices.front(), &Named::device);
    if (known == names.end())
      add({.device = one.devices.front(), .by = &one});
    else if (clearer(one, *known->by))
      known->by = &one;
  }
  for (const Accusation& one : accusations)
    if (one.test->fired() && !is_named(names, one.devices) && !is_explained(one, doubts) &&
        now - one.test->since() > patience)
      add(held(one, best_of(one, accusations, doubts)));
  held_.erase(std::remove_if(held_.begin(), held_.end(),
                             [](const Held& one) { return !one.test->fired(); }),
              held_.end());
  return names;
}

}  // namespace drydock::consistency

#include "estimators/consistency/parity.hpp"

#include <algorithm>

namespace drydock::consistency {
namespace {

constexpr double quiet_below = 0.3;

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
struct Explains {
  double fired = 0;
  int quiet = 0;
  bool operator<(const Explains& other) const {
    return fired != other.fired ? fired < other.fired : quiet > other.quiet;
  }
};

Explains explains(std::uint16_t device, const Accusations& accusations) {
  Explains sum;
  for (const Accusation& one : accusations) {
    if (!contains(one.devices, device)) continue;
    if (one.test->suspicion() < quiet_below)
      ++sum.quiet;
    else
      sum.fired += one.test->suspicion() < 1 ? 0.5 : 1;
  }
  return sum;
}

/// The device of a fired test that explains most; `alone`: better than the others.
Named best_of(const Accusation& fired, const Accusations& accusations) {
  Named best{.device = fired.devices.front(), .by = &fired};
  Explains most = explains(best.device, accusations);
  for (const auto device : fired.devices) {
    if (device == best.device) continue;
    const Explains its = explains(device, accusations);
    best.alone = most < its || its < most;
    if (!(most < its)) continue;
    most = its;
    best.device = device;
  }
  return best;
}

}  // namespace

Parity::Names Parity::name(const Accusations& accusations, Stamp now) const {
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
    if (one.test->fired() && !is_named(names, one.devices) && now - one.test->since() > patience)
      add(best_of(one, accusations));
  return names;
}

}  // namespace drydock::consistency

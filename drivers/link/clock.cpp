#include "drivers/link/clock.hpp"

#include "drivers/link/link.hpp"

namespace drydock::link {

namespace {

std::chrono::nanoseconds steady() { return std::chrono::steady_clock::now().time_since_epoch(); }

}  // namespace

Stamp now() {
  using namespace std::chrono;
  return Stamp{duration_cast<nanoseconds>(system_clock::now().time_since_epoch())};
}

Stamp steady_now() {
  static const auto offset = now() - Stamp{steady()};
  return Stamp{steady()} + offset;
}

std::chrono::nanoseconds ClockWatch::step() { return step(now(), steady()); }

/// Slow corrections (slewing) never add up to a step.
std::chrono::nanoseconds ClockWatch::step(Stamp utc, std::chrono::nanoseconds steady) {
  const auto offset = utc - Stamp{steady};
  const auto moved = begun_ ? offset - offset_ : std::chrono::nanoseconds{0};
  begun_ = true;
  offset_ = offset;
  return std::chrono::abs(moved) < smallest_step ? std::chrono::nanoseconds{0} : moved;
}

}  // namespace drydock::link

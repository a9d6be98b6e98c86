#include "estimators/consistency/levels.hpp"

#include <utility>

#include "drivers/measurement/units.hpp"

namespace drydock::consistency {
namespace {

/// A gyro that is off by 0.3 deg/s turns the level so fast; no accelerometer drifts so.
constexpr double fastest_drift_mps3 = 0.05;
/// Without a velocity the acceleration of the vehicle is an error, and so is what a turn of a speed
/// ahead makes of it. Nothing pulls the level while that may be large.
constexpr double unknown_acceleration_mps2 = 0.5, unknown_speed_mps = 10;
constexpr double most_unknown_mps2 = 1;
/// A specific force so far from gravity is an acceleration as large at least: no vehicle that
/// floats or stands has it, and one that falls shows no direction of gravity.
/// The acceleration by a receiver is made with the pitch: at the speed of a flight it errs by more.
constexpr double falls_mps2 = units::standard_gravity / 2;
constexpr double acceleration_share = 0.15, change_share = 1, acceleration_memory_s = 2;
/// A gyro's fault has turned the level; when that no longer goes on, the level begins anew.
constexpr double usual_memory_s = 60;  // as the level's own
constexpr double over_below_mps2 = 0.15, over_after_s = 3;

TestFacts facts_along(std::string_view quantity) {
  return {.floor = 0.06,
          .wander = 0.002,
          .late_s = 0,
          .sum_above = fastest_drift_mps3,
          .holds = true,
          .quantity = quantity,
          .unit = "m/s2"};
}

double unknown_acceleration(const InertialUnit& unit) {
  return std::hypot(unknown_acceleration_mps2, unknown_speed_mps * unit.rate().tail<2>().norm());
}

bool falls(const InertialUnit& unit) {
  return std::abs(unit.force().norm() - units::standard_gravity) > falls_mps2;
}

bool any_fired(const Levels::Unit& unit) {
  return std::ranges::any_of(unit.tests, [](const Test& test) { return test.fired(); });
}

/// The axis that is farthest off tells the kind of the fault. The others are off by what is not
/// known of a manoeuvre. An accelerometer's step stays as large as it was.
bool turned_away(const Levels::Unit& unit) {
  const auto off = [](const Test& test) {
    return test.fired() ? std::abs(test.evidence().deviation) : 0;
  };
  const Test& farthest = *std::ranges::max_element(unit.tests, {}, off);
  if (!farthest.fired()) return false;
  return farthest.shape() != Shape::step ||
         std::abs(farthest.deviation()) < std::abs(farthest.evidence().deviation) / 2;
}

/// The unit's force fits the level that another device tells: its gyro turned its own, in a moment.
bool fits_another(std::uint16_t device, const Moment& moment, const Eigen::Vector3d& gravity) {
  if (!moment.down || contains(moment.level_from, device)) return false;
  return (units::standard_gravity * *moment.down - gravity).norm() < over_below_mps2;
}

}  // namespace

Levels::Levels(Tracks& tracks) : tracks_(tracks) {
  for (const auto& unit : tracks.units)
    units_.push_back({.device = unit.device(),
                      .freeze = &unit.freeze(),
                      .tests{Test(facts_along("specific force ahead")),
                             Test(facts_along("specific force to starboard")),
                             Test(facts_along("specific force down"))}});
}

/// What a sound unit differs always is small; more was learned in a fault.
bool Levels::Unit::learned_fault() const {
  return std::ranges::any_of(
      tests, [](const Test& test) { return std::abs(test.offset()) > test.facts().floor; });
}

void Levels::note_fault(std::uint16_t device) {
  for (Unit& unit : units_) unit.at_fault = unit.at_fault || unit.device == device;
}

void Levels::forget(std::uint16_t device) {
  for (InertialUnit& unit : tracks_.units)
    if (unit.device() == device) unit.take_quick_level();
  for (Unit& unit : units_)
    if (unit.device == device) unit.restart();
}

/// The acceleration is as old as the slowest velocity; it is worth less while it changes.
void Levels::step(const Moment& moment, const std::optional<Eigen::Vector3d>& acceleration) {
  const Eigen::Vector3d known = acceleration.value_or(Eigen::Vector3d::Zero());
  const double change = (known - usual_acceleration_).norm();
  usual_acceleration_ +=
      (known - usual_acceleration_) * std::min(1.0, moment.dt / acceleration_memory_s);
  const double of_known = acceleration_share * known.norm() + change_share * change;
  const bool flies = known.norm() > falls_mps2;
  for (std::size_t i = 0; i < units_.size(); ++i) {
    InertialUnit& unit = tracks_.units[i];
    if (!unit.running() || (!moment.over_ground && (flies || falls(unit)))) continue;
    const double sigma = acceleration ? of_known : unknown_acceleration(unit);
    const bool at_fault = std::exchange(units_[i].at_fault, false);
    const bool pulls = (acceleration || sigma < most_unknown_mps2) && !at_fault;
    step(units_[i], unit, moment, known, sigma, pulls);
  }
}

/// What differs always may be the body's or the Earth's (its turn, the level's own error); straight
/// ahead both look the same. A turn parts them by so much.
double Levels::unsettled(Unit& unit, const InertialUnit& inertial,
                         const Eigen::Vector3d& difference, double dt) {
  const auto axes = inertial.level_axes();
  if (!axes) return 0;
  const double share = std::min(1.0, dt / usual_memory_s);
  unit.in_body += share * (difference - unit.in_body);
  unit.in_level += share * (axes->transpose() * difference - unit.in_level);
  return (axes->transpose() * unit.in_body - unit.in_level).norm();
}

void Levels::step(Unit& unit, InertialUnit& inertial, const Moment& moment,
                  const Eigen::Vector3d& acceleration, double sigma, bool pulls) {
  if (inertial.level_lost()) {
    unit.restart();
    unit.in_body.setZero(), unit.in_level.setZero();
  }
  const bool accused = any_fired(unit);
  const bool sound = pulls && !accused;
  const Eigen::Vector3d difference = inertial.level(acceleration, sound);
  const double turned = sound ? unsettled(unit, inertial, difference, moment.dt) : 0;
  for (int axis = 0; axis < 3; ++axis)
    unit.tests.at(static_cast<std::size_t>(axis))
        .take({.value = difference[axis], .sigma = std::hypot(sigma, turned)}, moment.at);
  const bool settled = inertial.quick_difference() < over_below_mps2;
  const bool fits = accused && difference.norm() < over_below_mps2;
  const bool over =
      settled && (fits || turned_away(unit) ||
                  (accused && fits_another(unit.device, moment, acceleration - inertial.force())));
  unit.over_s = over ? unit.over_s + moment.dt : 0;
  const bool acquitted = accused && !any_fired(unit) && settled;
  const bool anew = unit.over_s > over_after_s;
  if (acquitted || anew) inertial.take_quick_level();
  if (anew && unit.learned_fault()) unit.restart();
}

}  // namespace drydock::consistency

#include "estimators/consistency/checks.hpp"

namespace drydock::consistency {
namespace {

constexpr std::chrono::milliseconds period{200};
/// Without a velocity the turn of the vehicle looks like a heel.
constexpr double unknown_level_rad = 0.05;
/// A test without residuals says nothing.
constexpr std::chrono::seconds stale{3};
/// Behind a gap the checks begin anew.
constexpr std::chrono::seconds longest_pause{5};

constexpr double longest_period_s = 2.5;

/// The slowest sensor that votes must have sent the sample after the tested time.
std::chrono::nanoseconds lag_of(const std::vector<Sensor>& sensors) {
  double slowest_s = 0.1;
  for (const Sensor& sensor : sensors) slowest_s = std::max(slowest_s, 1 / sensor.rate_hz);
  return measurement::from_seconds(std::min(slowest_s, longest_period_s) + 0.2);
}

Tracks tracks_of(const std::vector<Sensor>& sensors) {
  using measurement::Kind;
  Tracks tracks;
  std::uint16_t i = 0;
  for (const Sensor& sensor : sensors) {
    switch (sensor.kind) {
      case Kind::dvl: tracks.dvls.emplace_back(i, sensor); break;
      case Kind::emlog: tracks.logs.emplace_back(i, sensor); break;
      case Kind::gnss: tracks.receivers.emplace_back(i, sensor); break;
      case Kind::imu: tracks.units.emplace_back(i, sensor); break;
      case Kind::depth: tracks.depths.emplace_back(i, sensor); break;
      case Kind::actuator: tracks.actuators.emplace_back(i, sensor); break;
      case Kind::attitude: tracks.compasses.emplace_back(i, sensor); break;
    }
    ++i;
  }
  return tracks;
}

std::vector<std::uint16_t> places_of(const std::vector<Sensor>& sensors) {
  std::array<std::uint16_t, measurement::kinds.size()> count{};
  std::vector<std::uint16_t> places;
  places.reserve(sensors.size());
  for (const Sensor& sensor : sensors)
    places.push_back(count.at(static_cast<std::size_t>(sensor.kind))++);
  return places;
}

}  // namespace

Checks::Checks(const std::vector<Sensor>& sensors, diagnosis::SymptomSink& to)
    : to_(to),
      tracks_(tracks_of(sensors)),
      place_(places_of(sensors)),
      doubts_(sensors),
      lag_(lag_of(sensors)),
      constants_(tracks_),
      speeds_(tracks_),
      headings_(tracks_),
      heights_(tracks_, constants_),
      immersion_(tracks_),
      dives_(tracks_, constants_),
      levels_(tracks_),
      attitudes_(tracks_),
      places_(tracks_),
      steering_(tracks_) {}

void Checks::take(const measurement::Measurement& measurement) {
  push(measurement);
  const Stamp now = measurement::origin_of(measurement).received_at;
  if (now - next_ > lag_ + longest_pause) next_ = now - lag_;
  for (; now - next_ >= lag_; next_ += period) step(next_);
}

void Checks::push(const measurement::Measurement& measurement) {
  using namespace measurement;
  const std::size_t place = place_.at(origin_of(measurement).device);
  if (const auto* imu = std::get_if<ImuSample>(&measurement)) tracks_.units.at(place).take(*imu);
  if (const auto* dvl = std::get_if<BottomVelocity>(&measurement))
    consistency::take(tracks_.dvls.at(place), *dvl);
  if (const auto* log = std::get_if<WaterSpeed>(&measurement))
    consistency::take(tracks_.logs.at(place), *log);
  if (const auto* fix = std::get_if<GnssFix>(&measurement))
    consistency::take(tracks_.receivers.at(place), *fix);
  if (const auto* depth = std::get_if<DepthSample>(&measurement))
    consistency::take(tracks_.depths.at(place), *depth);
  if (const auto* actuator = std::get_if<ActuatorState>(&measurement))
    consistency::take(tracks_.actuators.at(place), *actuator);
  if (const auto* attitude = std::get_if<AttitudeSample>(&measurement))
    consistency::take(tracks_.compasses.at(place), *attitude);
}

void Checks::step(Stamp at) {
  for (InertialUnit& unit : tracks_.units) unit.advance(at);
  doubt(at);
  Moment moment = moment_at(at);
  const auto distrusted = [&](const Devices& devices) { return !trusted(devices); };
  headings_.step(moment, distrusted);
  if (const auto heading = headings_.group().value())
    for (InertialUnit& unit : tracks_.units) unit.follow_heading(*heading);
  constants_.step(moment, distrusted);
  speeds_.step(moment, distrusted);
  heights_.step(moment, distrusted);
  immersion_.step(moment, distrusted);
  dives_.step(moment, distrusted);
  levels_.step(moment, acceleration(moment));
  attitudes_.step(moment);
  places_.step(moment);
  steering_.step(moment, speeds_.group().value(), speeds_.through_water(moment));
  accuse(moment);
  name(at);
  last_ = at;
}

Moment Checks::moment_at(Stamp at) {
  Moment moment{.at = at, .dt = last_ == Stamp{} ? 0 : measurement::seconds(at - last_)};
  double level_sigma = 0;
  for (const bool settled : {true, false})
    for (const InertialUnit& unit : tracks_.units) {
      if (!unit.running() || !trusted({unit.device()}) || moment.down) continue;
      if (settled && !unit.settled()) continue;
      if (!moment.rate || !unit.level_lost()) moment.rate = unit.rate();
      if (unit.level_lost()) continue;
      moment.down = unit.down();
      level_sigma = unit.level_sigma();
      moment.level_from.push_back(unit.device());
    }
  moment.rate_lost = !tracks_.units.empty() && !moment.rate;
  moment.heading = headings_.group().value().value_or(0);
  moment.heading_known = headings_.group().value().has_value();
  for (const DvlTracks& dvl : tracks_.dvls) {
    const auto read = dvl.velocity.at(at);
    if (!read || !trusted({dvl.device}) || moment.over_ground) continue;
    if (const auto own = dvl.down.at(at); own && !moment.down) moment.down = own->value;
    const Eigen::Vector3d velocity = at_origin(read->value, dvl.sensor.lever_arm_m, moment);
    moment.over_ground = levelled(velocity, moment);
    moment.along_deck = velocity.head<2>();
  }
  moment.level_sigma_rad = std::max(level_sigma, velocity(moment) ? 0 : unknown_level_rad);
  return moment;
}

/// Of a sound DVL, else of a sound log along the body.
std::optional<Eigen::Vector3d> Checks::velocity(const Moment& moment) const {
  for (const DvlTracks& dvl : tracks_.dvls)
    if (const auto read = dvl.velocity.at(moment.at); read && trusted({dvl.device}))
      return at_origin(read->value, dvl.sensor.lever_arm_m, moment);
  if (const auto speed = speeds_.group().value()) return *speed * Eigen::Vector3d::UnitX();
  return {};
}

/// dv/dt + w x v. While no unit is trusted the headings of others tell how the vehicle turns.
std::optional<Eigen::Vector3d> Checks::acceleration(const Moment& moment) {
  const auto before = last_velocity_;
  last_velocity_ = velocity(moment);
  if (!before || !last_velocity_ || moment.dt <= 0) return {};
  if (!moment.rate && !moment.heading_known) return {};
  const Eigen::Vector3d rate =
      moment.rate.value_or(headings_.group().rate() * Eigen::Vector3d::UnitZ());
  return (*last_velocity_ - *before) / moment.dt + rate.cross((*last_velocity_ + *before) / 2);
}

void Checks::accuse(const Devices& devices, const Test& test, const Freeze* freeze,
                    bool secondary) {
  if (test.learned() && next_ - test.last() < stale &&
      accusations_.size() < accusations_.capacity())
    accusations_.push_back({devices, &test, freeze, secondary});
}

void Checks::accuse(const Group& group) {
  for (const Witness& witness : group.witnesses())
    accuse(group.accused(witness), witness.test, witness.freeze);
}

/// While nothing is wrong, as nearly always, nobody is accused.
bool Checks::any_fired() const {
  const auto fired = [](const Test& test) { return test.fired(); };
  const auto has_fired = [&](const auto& one) { return std::ranges::any_of(one.tests, fired); };
  for (const Group* group :
       {&speeds_.group(), &speeds_.ahead(), &headings_.group(), &heights_.group()})
    if (std::ranges::any_of(group->witnesses(), fired, &Witness::test)) return true;
  return std::ranges::any_of(levels_.units(), has_fired) ||
         std::ranges::any_of(places_.receivers(), has_fired) ||
         std::ranges::any_of(attitudes_.compasses(), has_fired) ||
         std::ranges::any_of(steering_.rudders(), fired, &Steering::Rudder::test);
}

void Checks::accuse(const Moment& moment) {
  const auto with = [](std::uint16_t device, const Devices& others) {
    Devices all{device};
    for (const auto other : others) add(all, other);
    return all;
  };
  accusations_.clear();
  if (!any_fired()) return;
  accuse(speeds_.group());
  accuse(speeds_.ahead());
  accuse(headings_.group());
  accuse(heights_.group());
  for (const auto& unit : levels_.units())
    for (const Test& test : unit.tests) accuse({unit.device}, test, unit.freeze);
  for (const auto& receiver : places_.receivers())
    for (const Test& test : receiver.tests) accuse({receiver.device}, test, receiver.freeze, true);
  if (moment.level_from.empty()) return;  // nothing tests these now
  for (const auto& compass : attitudes_.compasses())
    for (const Test& test : compass.tests)
      accuse(with(compass.device, moment.level_from), test,
             &test == &compass.tests[2] ? compass.turn_freeze : compass.tilt_freeze);
  for (const auto& rudder : steering_.rudders())
    accuse(with(rudder.device, moment.level_from), rudder.test, rudder.freeze);
}

void Checks::tell(Stamp now) const {
  for (const Named& one : names_) {
    const Test& test = *one.by->test;
    if (test.is_open(one.by->freeze)) continue;
    const double unit = test.facts().unit_si;
    const Test::Evidence evidence = test.evidence();
    to_.see({.device = one.device,
             .sign = test.sign(one.by->freeze),
             .since = test.since(),
             .at = now,
             .value = evidence.deviation / unit,
             .limit = evidence.least / unit,
             .quantity = test.facts().quantity,
             .unit = test.facts().unit});
  }
  constants_.tell(now, to_, !speeds_.off());
  immersion_.tell(now, to_);
  speeds_.tell(now, to_);
}

}  // namespace drydock::consistency

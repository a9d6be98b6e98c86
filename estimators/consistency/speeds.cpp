#include "estimators/consistency/speeds.hpp"

#include <cmath>

namespace drydock::consistency {
namespace {

constexpr std::string_view quantity = "speed over ground";
constexpr TestFacts dvl_facts{.floor = 0.02,
                              .wander = 0.001,
                              .late_s = 0.1,
                              .may_be_late = true,
                              .scales = true,
                              .quantity = quantity,
                              .unit = "m/s"};
constexpr TestFacts receiver_facts{.floor = 0.04,
                                   .wander = 0.001,
                                   .late_s = 0.1,
                                   .may_be_late = true,
                                   .scales = true,
                                   .quantity = quantity,
                                   .unit = "m/s"};
constexpr TestFacts log_facts{.floor = 0.05,
                              .wander = 0.003,
                              .late_s = 0.25,
                              .may_be_late = true,
                              .scales = true,
                              .quantity = quantity,
                              .unit = "m/s"};
constexpr TestFacts shaft_facts{.floor = 0.025,
                                .wander = 0.002,
                                .late_s = 0.2,
                                .scales = true,
                                .holds = true,
                                .passes = true,
                                .is_often_equal = true,
                                .quantity = quantity,
                                .unit = "m/s"};

/// Sideways or astern, a speed has the same size: this test is for the direction alone.
constexpr TestFacts ahead_facts{
    .floor = 0.3, .wander = 0.003, .late_s = 0.25, .quantity = "speed ahead", .unit = "m/s"};

constexpr double usual_current_mps = 0.3;
constexpr double any_offset_mps = 1;       // 1 sigma of a log that may be wrong
constexpr double unknown_slope_rad = 0.2;  // 1 sigma of a pitch that no device tells

}  // namespace

Speeds::Speeds(const Tracks& tracks) : tracks_(tracks) {
  for (const auto& dvl : tracks.dvls)
    dvls_.push_back(group_.add({dvl.device}, dvl_facts, &dvl.velocity.freeze()));
  for (const auto& receiver : tracks.receivers)
    receivers_.push_back(
        group_.add({receiver.device}, receiver_facts, &receiver.velocity.freeze()));
  for (const auto& log : tracks.logs)
    logs_.push_back(group_.add({log.device}, log_facts, &log.speed.freeze()));
  for (const auto& actuator : tracks.actuators)
    shafts_.push_back(group_.add({actuator.device}, shaft_facts, &actuator.shaft.freeze(), true));
  for (const auto& dvl : tracks.dvls)
    dvls_ahead_.push_back(ahead_.add({dvl.device}, ahead_facts, &dvl.velocity.freeze()));
  for (const auto& log : tracks.logs)
    logs_ahead_.push_back(ahead_.add({log.device}, ahead_facts, &log.speed.freeze()));
  currents_.resize(logs_.size());
  off_currents_.resize(logs_.size(), Current(any_offset_mps));
  compared_.resize(logs_.size());
  learned_.resize(logs_.size());
  shaft_laws_.resize(shafts_.size());
  shafts_at_fault_.resize(shafts_.size());
}

void Speeds::see(const Moment& moment) {
  see_dvls(moment);
  see_receivers(moment);
  see_logs(moment);
  see_shafts(moment);
}

void Speeds::see_dvls(const Moment& moment) {
  for (std::size_t i = 0; i < dvls_.size(); ++i) {
    const auto& dvl = tracks_.dvls[i];
    const auto read = dvl.velocity.at(moment.at);
    if (!read) continue;
    const Eigen::Vector2d velocity =
        at_origin(read->value, dvl.sensor.lever_arm_m, moment).head<2>();
    const double sigma = lever_sigma(dvl.sensor.lever_arm_m, moment);
    group_.see(dvls_[i], velocity.norm(), read->serial, sigma);
    ahead_.see(dvls_ahead_[i], velocity.x(), read->serial, sigma);
  }
}

/// A pitched vehicle is faster along its deck than along the sea.
void Speeds::see_receivers(const Moment& moment) {
  const double slope = moment.down ? std::min(0.8, std::abs(moment.down->x())) : 0;
  const double unknown_share = moment.down ? 0 : 1 - std::cos(unknown_slope_rad);
  for (std::size_t i = 0; i < receivers_.size(); ++i) {
    const auto& receiver = tracks_.receivers[i];
    const auto read = receiver.velocity.at(moment.at);
    if (!read) continue;
    const Eigen::Vector3d antenna =
        read->value.norm() / std::sqrt(1 - slope * slope) * Eigen::Vector3d::UnitX();
    group_.see(
        receivers_[i], at_origin(antenna, receiver.sensor.lever_arm_m, moment).x(), read->serial,
        std::hypot(unknown_share * antenna.x(), lever_sigma(receiver.sensor.lever_arm_m, moment)));
  }
}

void Speeds::see_logs(const Moment& moment) {
  for (std::size_t i = 0; i < logs_.size(); ++i)
    if (const auto read = tracks_.logs[i].speed.at(moment.at)) {
      const Eigen::Vector2d velocity =
          water(i, read->value, moment) + currents_[i].at(moment.heading);
      const double sigma = std::hypot(current_sigma(i, moment),
                                      lever_sigma(tracks_.logs[i].sensor.lever_arm_m, moment));
      group_.see(logs_[i], velocity.norm(), read->serial, sigma);
      ahead_.see(logs_ahead_[i], velocity.x(), read->serial, sigma);
    }
}

/// Without a heading the current changes sides unseen.
double Speeds::current_sigma(std::size_t log, const Moment& moment) const {
  return std::hypot(std::sqrt(currents_[log].variance(moment.heading)),
                    moment.heading_known ? 0 : usual_current_mps);
}

/// Through the water at the origin. Across, a log that does not tell it moves with the ground.
Eigen::Vector2d Speeds::water(std::size_t log, const Eigen::Vector2d& read,
                              const Moment& moment) const {
  const LogTracks& tracks = tracks_.logs[log];
  const Eigen::Vector3d body{read.x(), read.y(), 0};
  Eigen::Vector2d through = at_origin(body, tracks.sensor.lever_arm_m, moment).head<2>();
  if (!tracks.across)
    through.y() = moment.along_deck.value_or(Eigen::Vector2d::Zero()).y() -
                  currents_[log].at(moment.heading).y();
  return through;
}

/// A propeller drives the hull ahead; what it drifts to the side, the DVL tells. Only a log tells
/// how the water moves.
void Speeds::see_shafts(const Moment& moment) {
  for (std::size_t i = 0; i < shafts_.size(); ++i) {
    const auto read = tracks_.actuators[i].shaft.at(moment.at);
    const auto made = shaft_laws_[i].answer();
    if (!read || !made || !moment.rate) continue;
    const bool current_known = !logs_.empty() && learned_[0] > 0 && moment.heading_known;
    const double current = current_known ? 0 : usual_current_mps;
    group_.see(shafts_[i], std::hypot(made->speed_mps, starboard(moment)), read->serial,
               std::hypot(made->sigma_mps, current));
  }
}

double Speeds::starboard(const Moment& moment) {
  return moment.along_deck.value_or(Eigen::Vector2d::Zero()).y();
}

Eigen::Vector2d Speeds::current(const Moment& moment) const {
  if (currents_.empty()) return Eigen::Vector2d::Zero();
  return is_log_off() ? currents_[0].water_at(moment.heading) : currents_[0].at(moment.heading);
}

bool Speeds::is_quiet(std::size_t witness) const {
  return witness < Group::most && group_.witnesses()[witness].test.suspicion() < 0.3;
}

bool Speeds::is_accused(std::size_t witness) const {
  return witness < Group::most && group_.witnesses()[witness].test.fired();
}

/// Only from devices that no test accuses.
void Speeds::learn(const Moment& moment) {
  learn_currents(moment);
  learn_surge(moment);
}

void Speeds::learn_currents(const Moment& moment) {
  for (std::size_t i = 0; i < logs_.size(); ++i) {
    const auto read = tracks_.logs[i].speed.at(moment.at);
    if (!read || !moment.along_deck || read->serial == compared_[i]) continue;
    compared_[i] = read->serial;
    const auto follow = [&](Current& current) {
      current.follow(*moment.along_deck - water(i, read->value, moment), tracks_.logs[i].across,
                     moment.heading, 1 / tracks_.logs[i].sensor.rate_hz);
    };
    if (moment.heading_known) follow(off_currents_[i]);
    if (!is_quiet(logs_[i])) continue;
    learned_[i] = read->serial;
    follow(currents_[i]);
  }
  if (!logs_.empty() && moment.along_deck && moment.heading_known) judge_offset(moment.at);
}

void Speeds::forget_dvl(Stamp since, Stamp now) {
  if (!first_ || now - since < since - *first_) return;
  for (std::size_t i = 0; i < logs_.size(); ++i) {
    currents_[i] = Current();
    off_currents_[i] = Current(any_offset_mps);
    learned_[i] = 0;
    group_.restart(logs_[i]);
  }
  forget_shafts();
}

void Speeds::note_fault(std::uint16_t device) {
  group_.note_fault(device);
  ahead_.note_fault(device);
  for (std::size_t i = 0; i < shafts_.size(); ++i)
    if (tracks_.actuators[i].device == device) shafts_at_fault_[i] = true;
}

void Speeds::forget_shafts() {
  for (std::size_t i = 0; i < shafts_.size(); ++i) {
    shaft_laws_[i] = {};
    group_.restart(shafts_[i]);
  }
}

/// The mean of all that is quiet, but for the shafts. Each counts by what is known of it now: a log
/// whose current no turn has shown yet is off by as much, for as long, and no later sample mends
/// what a law learned from it.
std::optional<double> Speeds::speed_of_others() const {
  double sum = 0, weights = 0;
  for (const auto* kind : {&dvls_, &receivers_, &logs_})
    for (const std::size_t i : *kind) {
      const Witness& one = group_.witnesses()[i];
      if (!is_quiet(i) || !one.present) continue;
      const double weight = 1 / (one.wide * one.wide);
      sum += weight * (one.value - one.test.offset());
      weights += weight;
    }
  return weights > 0 ? std::optional(sum / weights) : std::nullopt;
}

/// Ahead and to starboard, of a speed along the deck.
Eigen::Vector2d Speeds::along_deck(double speed_mps, const Moment& moment) {
  const double aside = starboard(moment);
  return {std::sqrt(std::max(0.0, speed_mps * speed_mps - aside * aside)), aside};
}

std::optional<double> Speeds::through_water(const Moment& moment) const {
  const auto speed = group_.value();
  if (currents_.empty() || !speed) return {};
  return (along_deck(*speed, moment) - current(moment)).norm();
}

void Speeds::learn_surge(const Moment& moment) {
  auto speed = speed_of_others();
  if (speed) speed = along_deck(*speed, moment).x();
  // Without the rate of turn the law is not judged.
  const auto turn = moment.rate ? std::optional(moment.rate->z()) : std::nullopt;
  const Eigen::Vector2d water = current(moment);
  for (std::size_t i = 0; i < shafts_.size(); ++i) {
    const auto read = tracks_.actuators[i].shaft.at(moment.at);
    const bool at_fault = shafts_at_fault_[i];
    shafts_at_fault_[i] = false;
    if (!read) continue;
    shaft_laws_[i].take({.shaft_radps = read->value.x(),
                         .speed_mps = at_fault ? std::nullopt : speed,
                         .starboard_mps = starboard(moment),
                         .turn_radps = turn,
                         .current_mps = water.x(),
                         .current_starboard_mps = water.y(),
                         .current_sigma_mps = logs_.empty() ? 0 : current_sigma(0, moment)},
                        moment.dt, is_quiet(shafts_[i]), is_accused(shafts_[i]));
    if (shaft_laws_[i].begins_anew()) group_.restart(shafts_[i]);
  }
}

}  // namespace drydock::consistency

#include "estimators/consistency/speeds.hpp"

#include <cmath>

namespace drydock::consistency {
namespace {

constexpr std::string_view quantity = "speed over ground";
constexpr TestFacts dvl_facts{.floor = 0.02,
                              .wander = 0.001,
                              .late_s = 0.1,
                              .scales = true,
                              .quantity = quantity,
                              .unit = "m/s"};
constexpr TestFacts receiver_facts{.floor = 0.04,
                                   .wander = 0.001,
                                   .late_s = 0.1,
                                   .scales = true,
                                   .quantity = quantity,
                                   .unit = "m/s"};
constexpr TestFacts log_facts{.floor = 0.05,
                              .wander = 0.003,
                              .late_s = 0.25,
                              .scales = true,
                              .quantity = quantity,
                              .unit = "m/s"};
constexpr TestFacts shaft_facts{.floor = 0.025,
                                .wander = 0.002,
                                .late_s = 0.5,
                                .scales = true,
                                .quantity = quantity,
                                .unit = "m/s"};

constexpr double slowest_mps = 0.3;  // below it a shaft or a course says little
constexpr double usual_current_mps = 0.3;
constexpr double advance_memory_s = 100;

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
    shafts_.push_back(group_.add({actuator.device}, shaft_facts, &actuator.shaft.freeze()));
  currents_.resize(logs_.size());
  learned_.resize(logs_.size());
  advances_m_.resize(shafts_.size());
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
    if (const auto read = dvl.velocity.at(moment.at))
      group_.see(dvls_[i], at_origin(read->value, dvl.sensor.lever_arm_m, moment).head<2>().norm(),
                 read->serial);
  }
}

/// A pitched vehicle is faster along its deck than along the sea.
void Speeds::see_receivers(const Moment& moment) {
  const double slope = moment.down ? std::min(0.8, std::abs(moment.down->x())) : 0;
  for (std::size_t i = 0; i < receivers_.size(); ++i) {
    const auto& receiver = tracks_.receivers[i];
    const auto read = receiver.velocity.at(moment.at);
    if (!read) continue;
    const Eigen::Vector3d antenna =
        read->value.norm() / std::sqrt(1 - slope * slope) * Eigen::Vector3d::UnitX();
    group_.see(receivers_[i], at_origin(antenna, receiver.sensor.lever_arm_m, moment).x(),
               read->serial);
  }
}

void Speeds::see_logs(const Moment& moment) {
  for (std::size_t i = 0; i < logs_.size(); ++i)
    if (const auto read = tracks_.logs[i].speed.at(moment.at))
      group_.see(logs_[i], (water(i, read->value, moment) + currents_[i].at(moment.heading)).norm(),
                 read->serial, current_sigma(i, moment));
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

void Speeds::see_shafts(const Moment& moment) {
  for (std::size_t i = 0; i < shafts_.size(); ++i)
    if (const auto read = tracks_.actuators[i].shaft.at(moment.at); read && advances_m_[i] > 0)
      group_.see(shafts_[i], advances_m_[i] * std::abs(read->value.x()), read->serial);
}

/// Only from devices that no test accuses.
void Speeds::learn(const Moment& moment) {
  shaft_s_ += moment.dt;
  const auto quiet = [&](std::size_t witness) {
    return witness < Group::most && group_.witnesses()[witness].test.suspicion() < 0.3;
  };
  for (std::size_t i = 0; i < logs_.size(); ++i) {
    const auto read = tracks_.logs[i].speed.at(moment.at);
    if (!read || !moment.along_deck || !quiet(logs_[i])) continue;
    if (read->serial == learned_[i]) continue;
    learned_[i] = read->serial;
    currents_[i].follow(*moment.along_deck - water(i, read->value, moment), tracks_.logs[i].across,
                        moment.heading, 1 / tracks_.logs[i].sensor.rate_hz);
  }
  for (std::size_t i = 0; i < shafts_.size(); ++i) {
    const auto read = tracks_.actuators[i].shaft.at(moment.at);
    if (!read || !group_.value() || *group_.value() < slowest_mps || !quiet(shafts_[i])) continue;
    const double advance = *group_.value() / std::max(std::abs(read->value.x()), 0.1);
    double& known = advances_m_[i];
    known += (advance - known) *
             (known > 0 ? moment.dt / std::clamp(shaft_s_, 2.0, advance_memory_s) : 1);
  }
}

}  // namespace drydock::consistency

#include "estimators/consistency/headings.hpp"

#include <cmath>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/mounted.hpp"

namespace drydock::consistency {
namespace {

using units::degree;

constexpr std::string_view quantity_of_heading = "heading";
constexpr TestFacts gyro_facts{.floor = 0.3 * degree,
                               .wander = 0.05 * degree,
                               .trend = 0.1 * degree,
                               .late_s = 0.05,
                               .sum_above = 0,
                               .quantity = "integrated turn",
                               .unit = "deg",
                               .unit_si = degree};
constexpr TestFacts compass_facts{.floor = 0.6 * degree,
                                  .wander = 0.05 * degree,
                                  .others_wander = 0.05 * degree,
                                  .late_s = 0.1,
                                  .may_be_late = true,
                                  .quantity = quantity_of_heading,
                                  .unit = "deg",
                                  .unit_si = degree};
constexpr TestFacts course_facts{.floor = 1 * degree,
                                 .wander = 0.05 * degree,
                                 .others_wander = 0.05 * degree,
                                 .late_s = 0.1,
                                 .quantity = "course",
                                 .unit = "deg",
                                 .unit_si = degree};

/// A course of so slow a vehicle is noise.
constexpr double slowest_course_mps = 0.7;

/// Without a DVL the antenna slips in turns: it lies up to so far from the point that does not.
constexpr double pivot_m = 2, unknown_slip_rad = 2 * degree, slowest_without_dvl_mps = 2;

double slip_sigma(const Moment& moment, double speed_mps) {
  if (moment.over_ground) return 0;
  const double turn = moment.rate ? moment.rate->norm() : 0;
  return std::hypot(unknown_slip_rad, turn * pivot_m / speed_mps);
}

/// 1 sigma of a receiver's velocity: it turns the course of a slow vehicle by more than that of a
/// usual one, from which the spread is learned.
constexpr double velocity_noise_mps = 0.05, usual_speed_mps = 2;

double slow_sigma(double speed_mps) {
  const double more = 1 / (speed_mps * speed_mps) - 1 / (usual_speed_mps * usual_speed_mps);
  return velocity_noise_mps * std::sqrt(std::max(0.0, more));
}

/// The vehicle's heading by a DVL's own compass: that of its head, turned by the mounting and by
/// the head's tilts, else by those of other devices, else as on a level vehicle.
std::optional<Track<1>::Reading> body_heading(const DvlTracks& dvl, const Moment& moment) {
  auto read = dvl.heading.at(moment.at);
  if (!read) return {};
  Eigen::Vector3d down = moment.down.value_or(Eigen::Vector3d::UnitZ());
  if (const auto own = dvl.down.at(moment.at)) down = own->value.normalized();
  read->value.x() += frame::heading_beside_sensor(down, dvl.sensor.sensor_to_body);
  return read;
}

}  // namespace

Headings::Headings(const Tracks& tracks) : tracks_(tracks) {
  for (const auto& unit : tracks.units)
    units_.push_back(group_.add({unit.device()}, gyro_facts, &unit.freeze()));
  for (const auto& dvl : tracks.dvls)
    dvls_.push_back(group_.add({dvl.device}, compass_facts, &dvl.heading.freeze()));
  for (const auto& compass : tracks.compasses)
    compasses_.push_back(group_.add({compass.device}, compass_facts, &compass.heading.freeze()));
  for (const auto& receiver : tracks.receivers)
    receivers_.push_back(group_.add({receiver.device}, course_facts, &receiver.velocity.freeze()));
}

void Headings::see(const Moment& moment) {
  for (std::size_t i = 0; i < units_.size(); ++i) {
    if (!tracks_.units[i].running()) continue;
    if (tracks_.units[i].resumed()) group_.restart(units_[i]);
    group_.see(units_[i], tracks_.units[i].heading(), tracks_.units[i].serial());
  }
  for (std::size_t i = 0; i < dvls_.size(); ++i)
    if (const auto read = body_heading(tracks_.dvls[i], moment))
      group_.see(dvls_[i], read->value.x(), read->serial);
  for (std::size_t i = 0; i < compasses_.size(); ++i)
    if (const auto read = tracks_.compasses[i].heading.at(moment.at))
      group_.see(compasses_[i], read->value.x(), read->serial);
  see_courses(moment);
}

void Headings::see_courses(const Moment& moment) {
  for (std::size_t i = 0; i < receivers_.size(); ++i) {
    const auto read = tracks_.receivers[i].velocity.at(moment.at);
    const double speed_mps = read ? read->value.norm() : 0;
    if (speed_mps < (moment.over_ground ? slowest_course_mps : slowest_without_dvl_mps)) continue;
    Eigen::Vector2d drift{speed_mps, 0};
    if (moment.over_ground) drift = *moment.over_ground;
    if (moment.rate) drift.y() += moment.rate->z() * tracks_.receivers[i].sensor.lever_arm_m.x();
    const double course = std::atan2(read->value.y(), read->value.x());
    group_.see(receivers_[i], course - std::atan2(drift.y(), drift.x()), read->serial,
               std::hypot(slip_sigma(moment, speed_mps), slow_sigma(speed_mps)));
  }
}

}  // namespace drydock::consistency

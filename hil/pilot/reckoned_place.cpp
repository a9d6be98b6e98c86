#include "hil/pilot/reckoned_place.hpp"

#include <algorithm>

namespace drydock::pilot {

ReckonedPlace::Source ReckonedPlace::first_of(const rig_config::Rig& rig,
                                              rig_config::DeviceKind kind) {
  const auto found = std::ranges::find(rig.devices, kind, &rig_config::DeviceConfig::kind);
  if (found == rig.devices.end()) return {};
  return {static_cast<std::uint16_t>(found - rig.devices.begin()),
          Eigen::Vector3d(found->lever_arm_m.data())};
}

ReckonedPlace::ReckonedPlace(const rig_config::Rig& rig, Stamp start)
    : dvl_(first_of(rig, rig_config::DeviceKind::dvl)),
      gnss_(first_of(rig, rig_config::DeviceKind::gnss)),
      at_{rig.mission.latitude_rad, rig.mission.longitude_rad, 0},
      reckoned_at_(start) {}

void ReckonedPlace::receive(const measurement::Measurement& m) {
  if (const auto* velocity = std::get_if<measurement::BottomVelocity>(&m)) {
    if (velocity->origin.device != dvl_.device || !velocity->velocity) return;
    over_ground_ = velocity->velocity;
    over_ground_at_ = velocity->origin.valid_at;
  } else if (const auto* fix = std::get_if<measurement::GnssFix>(&m)) {
    if (fix->origin.device == gnss_.device && fix->position) fix_ = fix->position;
  }
}

Eigen::Vector3d ReckonedPlace::velocity_ned(const motion::VehicleState& state, Stamp now) const {
  Eigen::Vector3d body = state.velocity.head<3>();
  if (over_ground_ && now - over_ground_at_ <= MeasuredState::oldest)
    body = *over_ground_ - state.velocity.tail<3>().cross(dvl_.lever_arm_m);
  return state.body_to_ned * body;
}

void ReckonedPlace::place(motion::VehicleState& state, Stamp now) {
  if (fix_) {
    const Eigen::Vector3d antenna = state.body_to_ned * gnss_.lever_arm_m;
    at_ = frame::at_ned_offset({fix_->latitude_rad, fix_->longitude_rad, 0},
                               {-antenna.x(), -antenna.y(), 0});
    fix_.reset();
  } else {
    const auto passed =
        std::min<std::chrono::nanoseconds>(now - reckoned_at_, MeasuredState::oldest);
    const Eigen::Vector3d way = velocity_ned(state, now) * measurement::seconds(passed);
    at_ = frame::at_ned_offset(at_, {way.x(), way.y(), 0});
  }
  at_.height_m = 0;
  reckoned_at_ = now;
  state.latitude_rad = at_.latitude_rad;
  state.longitude_rad = at_.longitude_rad;
}

}  // namespace drydock::pilot

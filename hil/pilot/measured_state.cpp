#include "hil/pilot/measured_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "estimators/frame/attitude.hpp"

namespace drydock::pilot {

namespace {

using rig_config::DeviceKind;

std::size_t index_of(const rig_config::Rig& rig, DeviceKind kind) {
  const auto found = std::ranges::find(rig.devices, kind, &rig_config::DeviceConfig::kind);
  if (found == rig.devices.end())
    throw std::runtime_error(fmt::format(
        "an autopilot that steers over the wires sails by devices of kind attitude, depth, "
        "emlog and imu; there is none of kind {}",
        to_string(kind)));
  return static_cast<std::size_t>(found - rig.devices.begin());
}

}  // namespace

MeasuredState::MeasuredState(const rig_config::Rig& rig) {
  const auto source = [&](DeviceKind kind) {
    const std::size_t index = index_of(rig, kind);
    return Source{static_cast<std::uint16_t>(index),
                  Eigen::Vector3d(rig.devices[index].lever_arm_m.data())};
  };
  attitude_ = source(DeviceKind::attitude);
  depth_ = source(DeviceKind::depth);
  log_ = source(DeviceKind::emlog);
  imu_ = source(DeviceKind::imu);
}

void MeasuredState::receive(const measurement::Measurement& m) {
  std::visit([this](const auto& sample) { take(sample); }, m);
}

void MeasuredState::take(const measurement::AttitudeSample& sample) {
  if (sample.origin.device != attitude_.device) return;
  const auto keep = [&](const std::optional<double>& value, std::optional<Value>& into) {
    if (value) into = Value{*value, sample.origin.valid_at};
  };
  keep(sample.roll_rad, roll_);
  keep(sample.pitch_rad, pitch_);
  keep(sample.true_heading_rad ? sample.true_heading_rad : sample.heading_rad, heading_);
}

void MeasuredState::take(const measurement::DepthSample& sample) {
  if (sample.origin.device == depth_.device && sample.depth_m)
    depth_m_ = Value{*sample.depth_m, sample.origin.valid_at};
}

void MeasuredState::take(const measurement::WaterSpeed& sample) {
  if (sample.origin.device == log_.device && sample.longitudinal_mps)
    speed_mps_ = Value{*sample.longitudinal_mps, sample.origin.valid_at};
}

void MeasuredState::take(const measurement::ImuSample& sample) {
  if (sample.origin.device != imu_.device) return;
  rates_ = sample.angular_rate;
  rates_known_ = Value{0, sample.origin.valid_at};
}

std::string_view MeasuredState::missing(Stamp now) const {
  if (!fresh(heading_, now)) return "heading";
  if (!fresh(roll_, now) || !fresh(pitch_, now)) return "roll and pitch";
  if (!fresh(depth_m_, now)) return "depth";
  if (!fresh(speed_mps_, now)) return "speed through the water";
  return fresh(rates_known_, now) ? "" : "rates of turn";
}

/// The Earth's turn is left in the rates: 0.004 degrees a second.
std::optional<motion::VehicleState> MeasuredState::at(Stamp now) const {
  if (!missing(now).empty()) return {};
  motion::VehicleState state;
  state.body_to_ned = frame::body_to_ned({roll_->value, pitch_->value, heading_->value});
  state.height_m = -(depth_m_->value - (state.body_to_ned * depth_.lever_arm_m).z());
  state.velocity[0] = speed_mps_->value - rates_.cross(log_.lever_arm_m).x();
  state.velocity.tail<3>() = rates_;
  return state;
}

}  // namespace drydock::pilot

#include "drivers/wire/cia404_imu.hpp"

#include <algorithm>

#include "hil/emulate/devices.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

using wire::canopen::NmtCommand;
using wire::canopen::NodeState;

constexpr std::uint8_t default_node = 1;
constexpr std::chrono::seconds heartbeat_period{1};

std::array<std::optional<double>, 3> components(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

class Cia404Imu final : public SamplingDevice {
 public:
  explicit Cia404Imu(const DeviceSetup& setup)
      : SamplingDevice(setup),
        node_(setup.config.address != 0 ? static_cast<std::uint8_t>(setup.config.address)
                                        : default_node),
        gyro_errors_(setup.primary_errors()),
        accelerometer_errors_(setup.secondary_errors()),
        next_heartbeat_(setup.trajectory.start()) {}

  std::optional<Stamp> deadline() const override {
    return std::min(*SamplingDevice::deadline(), next_heartbeat_);
  }

  void tick(Stamp now, Wire& out) override {
    if (next_heartbeat_ <= now) beat(now, out);
    SamplingDevice::tick(now, out);
  }

  using SamplingDevice::receive;
  void receive(const wire::CanFrame& frame, Stamp now, Wire& out) override {
    const auto order = wire::canopen::decode_nmt(frame);
    if (!order || (order->node != 0 && order->node != node_)) return;
    switch (order->command) {
      case NmtCommand::start: state_ = NodeState::operational; break;
      case NmtCommand::stop: state_ = NodeState::stopped; break;
      case NmtCommand::enter_pre_operational: state_ = NodeState::pre_operational; break;
      case NmtCommand::reset_node:
      case NmtCommand::reset_communication:
        state_ = NodeState::boot_up;
        beat(now, out);
        break;
    }
  }

 private:
  // The first beat says "boot-up"; the node is then pre-operational until it is started.
  void beat(Stamp now, Wire& out) {
    out.send(encode(wire::canopen::Heartbeat{node_, state_}));
    if (state_ == NodeState::boot_up) state_ = NodeState::pre_operational;
    next_heartbeat_ = now + heartbeat_period;
  }

  void sample(Stamp at, Wire& out) override {
    if (state_ != NodeState::operational) return;
    const auto ideal = sensor::ideal_imu(trajectory(), at, mounting());
    wire::cia404_imu::ImuSet set;
    set.node = node_;
    set.rate_radps = components(gyro_errors_.apply(ideal.angular_rate));
    set.specific_force_mps2 = components(accelerometer_errors_.apply(ideal.specific_force));
    for (const wire::CanFrame& frame : encode(set)) out.send(frame);
  }

  std::uint8_t node_;
  sensor::ErrorModel gyro_errors_, accelerometer_errors_;
  NodeState state_ = NodeState::boot_up;
  Stamp next_heartbeat_;
};

}  // namespace

DevicePtr make_cia404_imu(const DeviceSetup& setup) { return std::make_unique<Cia404Imu>(setup); }

}  // namespace drydock::emulate

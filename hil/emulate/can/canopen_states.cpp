#include "drivers/wire/canopen/canopen.hpp"
#include "hil/emulate/can/canopen_device.hpp"

/// The states of an emulated node: boot-up, network management, and the watch on its master.
namespace drydock::emulate {
namespace {

namespace canopen = wire::canopen;
using canopen::NmtCommand;
using canopen::NodeState;

}  // namespace

/// The first beat is the boot-up message. The node is then pre-operational until NMT starts it.
void CanopenDevice::beat(Stamp now, Wire& out) {
  out.send(canopen::encode(canopen::Heartbeat{node_, state_}));
  if (state_ == NodeState::boot_up) state_ = NodeState::pre_operational;
  next_heartbeat_.reset();
  if (settings_.heartbeat_ms > 0)
    next_heartbeat_ = now + std::chrono::milliseconds{settings_.heartbeat_ms};
}

void CanopenDevice::obey(const canopen::Nmt& order, Stamp now, Wire& out) {
  if (order.node != 0 && order.node != node_) return;
  switch (order.command) {
    case NmtCommand::start: return enter(NodeState::operational, now);
    case NmtCommand::stop: return enter(NodeState::stopped, now);
    case NmtCommand::enter_pre_operational: return enter(NodeState::pre_operational, now);
    case NmtCommand::reset_node: return power_on(true, now, out);
    case NmtCommand::reset_communication: return power_on(false, now, out);
  }
}

void CanopenDevice::enter(NodeState state, Stamp now) {
  if (state == state_) return;
  state_ = state;
  sdo_.restart();
  synced_.reset();
  waiting_.fill(std::nullopt);
  if (is_operational()) {
    schedule_.begin(tpdos_, now);
  } else {
    schedule_.end();
  }
}

void CanopenDevice::power_on(bool application, Stamp now, Wire& out) {
  if (application) reset_application(now);
  const bool rested = !any_at_samples(tpdos_);
  recall();
  if (rested && any_at_samples(tpdos_)) go_on_at_whole_multiples(rate_hz(), now);
  enter(NodeState::boot_up, now);
  life_.restart();
  beat(now, out);
}

/// Guarding is for nodes without heartbeat (CiA 301, 7.2.8.3.2.2).
void CanopenDevice::answer_guarding(Stamp now, Wire& out) {
  if (settings_.heartbeat_ms != 0) return;
  if (life_.hear_guarding(settings_, now)) find_master(out);
  constexpr std::uint8_t toggle = 0x80;
  auto answer = canopen::encode(canopen::Heartbeat{node_, state_});
  if (life_.next_toggle()) answer.data[0] |= toggle;
  out.send(answer);
}

void CanopenDevice::mind_master(Stamp now, Wire& out) {
  if (!life_.is_lost(now)) return;
  set_fault(sdo::master_lost, sdo::communication_error, out);
  lose_master(now, out);
  if (!is_operational() || settings_.when_lost == CanopenSettings::stays) return;
  enter(settings_.when_lost == CanopenSettings::to_stopped ? NodeState::stopped
                                                           : NodeState::pre_operational,
        now);
}

}  // namespace drydock::emulate

#include "hil/emulate/canopen_device.hpp"

#include <algorithm>

namespace drydock::emulate {
namespace {

namespace canopen = wire::canopen;
using canopen::NmtCommand;
using canopen::NodeState;

constexpr std::uint8_t default_node = 1;
constexpr canopen::ObjectEntry device_type_entry{0x1000, 0}, error_register_entry{0x1001, 0},
    heartbeat_entry{0x1017, 0};
constexpr std::uint32_t read_only = 0x06010002, no_such_object = 0x06020000,
                        length_differs = 0x06070010;

void earlier_of(std::optional<Stamp>& first, const std::optional<Stamp>& other) {
  if (other && (!first || *other < *first)) first = other;
}

}  // namespace

CanopenDevice::CanopenDevice(const DeviceSetup& setup, std::uint32_t device_type)
    : SamplingDevice(setup),
      node_(setup.config.address != 0 ? static_cast<std::uint8_t>(setup.config.address)
                                      : default_node),
      device_type_(device_type),
      on_sync_(setup.config.sync),
      next_heartbeat_(setup.trajectory.start()) {}

std::optional<Stamp> CanopenDevice::deadline() const {
  auto next = on_sync_ ? std::optional<Stamp>{} : SamplingDevice::deadline();
  if (synced_) earlier_of(next, *synced_ + latency());
  earlier_of(next, next_heartbeat_);
  return next;
}

void CanopenDevice::tick(Stamp now, Wire& out) {
  if (next_heartbeat_ && *next_heartbeat_ <= now) beat(now, out);
  if (synced_ && *synced_ + latency() <= now) {
    sample(*synced_, out);
    synced_.reset();
  }
  if (!on_sync_) SamplingDevice::tick(now, out);
}

void CanopenDevice::sample(Stamp at, Wire& out) {
  if (state_ == NodeState::operational) report(at, out);
}

/// The first beat says "boot-up"; the node is then pre-operational until it is started.
void CanopenDevice::beat(Stamp now, Wire& out) {
  out.send(canopen::encode(canopen::Heartbeat{node_, state_}));
  if (state_ == NodeState::boot_up) state_ = NodeState::pre_operational;
  next_heartbeat_.reset();
  if (heartbeat_period_.count() > 0) next_heartbeat_ = now + heartbeat_period_;
}

void CanopenDevice::receive(const wire::CanFrame& frame, Stamp now, Wire& out) {
  if (state_ == NodeState::boot_up) return;
  if (const auto order = canopen::decode_nmt(frame)) return obey(*order, now, out);
  if (on_sync_ && canopen::is_sync(frame)) synced_ = now;
  if (state_ == NodeState::stopped) return;
  if (const auto request = canopen::decode_sdo_request(frame)) {
    if (const auto* read = std::get_if<canopen::SdoRead>(&*request)) return serve(*read, out);
    serve(std::get<canopen::SdoWrite>(*request), now, out);
  }
}

void CanopenDevice::obey(const canopen::Nmt& order, Stamp now, Wire& out) {
  if (order.node != 0 && order.node != node_) return;
  switch (order.command) {
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

void CanopenDevice::serve(const canopen::SdoRead& request, Wire& out) const {
  if (request.node != node_) return;
  std::optional<Object> found;
  if (request.entry == device_type_entry) {
    found = Object{device_type_, 4};
  } else if (request.entry == error_register_entry) {
    found = Object{error_register_, 1};
  } else if (request.entry == heartbeat_entry) {
    found = Object{static_cast<std::uint32_t>(heartbeat_period_.count()), 2};
  } else {
    found = object(request.entry);
  }
  if (found) {
    out.send(canopen::encode(canopen::SdoValue{node_, request.entry, found->value, found->size}));
  } else {
    out.send(canopen::encode(canopen::SdoAbort{node_, request.entry, no_such_object}));
  }
}

void CanopenDevice::serve(const canopen::SdoWrite& request, Stamp now, Wire& out) {
  if (request.node != node_) return;
  const auto refuse = [&](std::uint32_t code) {
    out.send(canopen::encode(canopen::SdoAbort{node_, request.entry, code}));
  };
  if (request.entry != heartbeat_entry) {
    const bool known = request.entry == device_type_entry ||
                       request.entry == error_register_entry || object(request.entry);
    return refuse(known ? read_only : no_such_object);
  }
  if (request.size != 2) return refuse(length_differs);
  heartbeat_period_ = std::chrono::milliseconds{request.value};
  next_heartbeat_.reset();
  if (heartbeat_period_.count() > 0) next_heartbeat_ = now + heartbeat_period_;
  out.send(canopen::encode(canopen::SdoWritten{node_, request.entry}));
}

void CanopenDevice::set_fault(std::uint16_t code, std::uint8_t error_register, Wire& out) {
  if (code == fault_) return;
  fault_ = code;
  error_register_ = error_register;
  out.send(canopen::encode(canopen::Emergency{node_, code, error_register, {}}));
}

}  // namespace drydock::emulate

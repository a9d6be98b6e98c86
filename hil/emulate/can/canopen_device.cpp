#include "hil/emulate/can/canopen_device.hpp"

#include "drivers/measurement/earlier.hpp"

#include "rig_config/fault_vocabulary.hpp"

namespace drydock::emulate {
namespace {

namespace canopen = wire::canopen;
using canopen::NmtCommand;
using canopen::NodeState;

constexpr std::uint8_t default_node = 1;
constexpr canopen::ObjectEntry device_type_entry{0x1000, 0}, error_register_entry{0x1001, 0},
    heartbeat_entry{0x1017, 0};
constexpr std::uint16_t identity_index = 0x1018, rpdo_index = 0x1400, rpdo_mapping_index = 0x1600,
                        tpdo_index = 0x1800, tpdo_mapping_index = 0x1A00;
constexpr std::uint32_t first_rpdo = 0x200, first_tpdo = 0x180;  // predefined connection set
constexpr std::uint32_t read_only = 0x06010002, no_such_object = 0x06020000,
                        no_such_subindex = 0x06090011, length_differs = 0x06070010,
                        not_in_this_state = 0x08000022;

}  // namespace

CanopenDevice::CanopenDevice(const DeviceSetup& setup, std::uint32_t device_type)
    : SamplingDevice(setup),
      node_(setup.config.address != 0 ? static_cast<std::uint8_t>(setup.config.address)
                                      : default_node),
      device_type_(device_type),
      on_sync_(setup.config.sync),
      tpdos_(tpdo_index, tpdo_mapping_index, first_tpdo + node_),
      rpdos_(rpdo_index, rpdo_mapping_index, first_rpdo + node_),
      next_heartbeat_(setup.boot) {
  reset_pdos();
}

void CanopenDevice::reset_pdos() {
  tpdos_.reset(on_sync_ ? CanopenPdos::on_each_sync : CanopenPdos::by_the_profile);
  rpdos_.reset(CanopenPdos::by_the_profile);
}

std::optional<Stamp> CanopenDevice::deadline() const {
  auto next = samples_by_time() ? SamplingDevice::deadline() : std::optional<Stamp>{};
  if (synced_) next = measurement::earlier(next, *synced_ + latency());
  return measurement::earlier(next, next_heartbeat_);
}

void CanopenDevice::tick(Stamp now, Wire& out) {
  if (next_heartbeat_ && *next_heartbeat_ <= now) beat(now, out);
  if (synced_ && *synced_ + latency() <= now) {
    by_sync_ = true;
    take(*synced_, out);
    by_sync_ = false;
    synced_.reset();
  }
  if (samples_by_time()) SamplingDevice::tick(now, out);
}

void CanopenDevice::sample(Stamp at, Wire& out) {
  watch(at, out);
  if (state_ != NodeState::operational) return;
  std::array<bool, CanopenPdos::most> goes{};
  for (std::size_t i = 0; i < pdos().size(); ++i) {
    const bool due = by_sync_ ? tpdos_.due_on_sync(i) : !tpdos_[i].is_synchronous();
    goes[i] = due && tpdos_[i].is_on();
  }
  ChosenPdos chosen(out, tpdos_, goes);
  report(at, chosen);
}

/// The first beat is the boot-up message. The node is then pre-operational until NMT starts it.
void CanopenDevice::beat(Stamp now, Wire& out) {
  out.send(canopen::encode(canopen::Heartbeat{node_, state_}));
  if (state_ == NodeState::boot_up) state_ = NodeState::pre_operational;
  next_heartbeat_.reset();
  if (heartbeat_period_.count() > 0) next_heartbeat_ = now + heartbeat_period_;
}

void CanopenDevice::receive(const wire::CanFrame& frame, Stamp now, Wire& out) {
  if (state_ == NodeState::boot_up) return;
  if (const auto order = canopen::decode_nmt(frame)) return obey(*order, now, out);
  if (canopen::is_sync(frame) && samples_on_sync()) synced_ = now;
  if (state_ == NodeState::stopped) return;
  if (const auto request = canopen::decode_sdo_request(frame)) {
    if (const auto* read = std::get_if<canopen::SdoRead>(&*request)) return serve(*read, out);
    return serve(std::get<canopen::SdoWrite>(*request), now, out);
  }
  if (const auto refusal = canopen::refuse_other_request(frame)) {
    if (refusal->node == node_) out.send(canopen::encode(*refusal));
    return;
  }
  hear(frame, now, out);
}

void CanopenDevice::obey(const canopen::Nmt& order, Stamp now, Wire& out) {
  if (order.node != 0 && order.node != node_) return;
  switch (order.command) {
    case NmtCommand::start: state_ = NodeState::operational; break;
    case NmtCommand::stop: state_ = NodeState::stopped; break;
    case NmtCommand::enter_pre_operational: state_ = NodeState::pre_operational; break;
    case NmtCommand::reset_node: return power_on(true, now, out);
    case NmtCommand::reset_communication: return power_on(false, now, out);
  }
}

void CanopenDevice::power_on(bool application, Stamp now, Wire& out) {
  if (application) reset_application(now);
  reset_communication();
  const bool rested = !samples_by_time();
  reset_pdos();
  if (rested && samples_by_time()) go_on_at_whole_multiples(rate_hz(), now);
  heartbeat_period_ = power_on_heartbeat;
  state_ = NodeState::boot_up;
  beat(now, out);
}

std::optional<CanopenDevice::Object> CanopenDevice::find(const canopen::ObjectEntry& entry) const {
  if (entry == device_type_entry) return Object{device_type_, 4};
  if (entry == error_register_entry) return Object{error_register_, 1};
  if (entry == heartbeat_entry) {
    return Object{static_cast<std::uint32_t>(heartbeat_period_.count()), 2};
  }
  if (entry == canopen::ObjectEntry{identity_index, 0}) return Object{1, 1};
  if (entry == canopen::ObjectEntry{identity_index, 1}) return Object{0, 4};  // no real product
  for (const auto& found : {tpdos_.read(entry, pdos()), rpdos_.read(entry, taken_pdos())})
    if (found) return Object{found->value, found->size};
  return object(entry);
}

/// The code for an entry that is not there: of an object that is, only the sub-index is wrong.
std::uint32_t CanopenDevice::missing(const canopen::ObjectEntry& entry) const {
  for (unsigned sub = 0; sub < 0xFF; ++sub)
    if (find({entry.index, static_cast<std::uint8_t>(sub)})) return no_such_subindex;
  return no_such_object;
}

/// A node that sampled on SYNC alone begins to sample by its own time from now on.
std::optional<std::uint32_t> CanopenDevice::set_pdo(const canopen::SdoWrite& request, Stamp now) {
  const bool rested = !samples_by_time();
  auto code = tpdos_.write(request, pdos());
  if (!code) code = rpdos_.write(request, taken_pdos());
  if (rested && samples_by_time()) go_on_at_whole_multiples(rate_hz(), now);
  return code;
}

void CanopenDevice::serve(const canopen::SdoRead& request, Wire& out) const {
  if (request.node != node_) return;
  const auto found = find(request.entry);
  if (found) {
    out.send(canopen::encode(canopen::SdoValue{node_, request.entry, found->value, found->size}));
  } else {
    out.send(canopen::encode(canopen::SdoAbort{node_, request.entry, missing(request.entry)}));
  }
}

void CanopenDevice::serve(const canopen::SdoWrite& request, Stamp now, Wire& out) {
  if (request.node != node_) return;
  if (const auto code = refusal_of(request, now, out)) {
    out.send(canopen::encode(canopen::SdoAbort{node_, request.entry, *code}));
  } else {
    out.send(canopen::encode(canopen::SdoWritten{node_, request.entry}));
  }
}

/// Sets the object; empty: it is set.
std::optional<std::uint32_t> CanopenDevice::refusal_of(const canopen::SdoWrite& request, Stamp now,
                                                       Wire& out) {
  if (condition().under(FaultKind::nak)) return not_in_this_state;
  if (request.entry != heartbeat_entry) {
    auto code = set_pdo(request, now);
    if (!code) code = set(request, now, out);
    if (!code) return find(request.entry) ? read_only : missing(request.entry);
    return *code == 0 ? std::nullopt : code;
  }
  if (request.size != 2) return length_differs;
  heartbeat_period_ = std::chrono::milliseconds{request.value};
  next_heartbeat_.reset();
  if (heartbeat_period_.count() > 0) next_heartbeat_ = now + heartbeat_period_;
  return {};
}

void CanopenDevice::set_fault(std::uint16_t code, std::uint8_t error_register, Wire& out) {
  if (code == fault_) return;
  fault_ = code;
  error_register_ = error_register;
  out.send(canopen::encode(canopen::Emergency{node_, code, error_register, {}}));
}

}  // namespace drydock::emulate

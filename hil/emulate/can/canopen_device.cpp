#include "hil/emulate/can/canopen_device.hpp"

#include "drivers/measurement/earlier.hpp"
#include "drivers/wire/bytes.hpp"
#include "hil/emulate/can/j1939_node.hpp"

namespace drydock::emulate {
namespace {

namespace canopen = wire::canopen;
using canopen::NodeState;

constexpr std::uint8_t default_node = 1;

std::uint8_t node_of(const DeviceSetup& setup) {
  const auto address = setup.config.address;
  return address != 0 ? static_cast<std::uint8_t>(address) : default_node;
}

std::uint8_t type_of(const DeviceSetup& setup) {
  return setup.config.sync ? CanopenPdo::on_each_sync : CanopenPdo::by_the_profile;
}

/// Is it asked for by this identifier, in no data frame.
bool asks_for(const wire::CanFrame& frame, std::uint32_t id) {
  return frame.remote && !frame.extended && !frame.error && frame.id == id;
}

}  // namespace

CanopenDevice::CanopenDevice(const DeviceSetup& setup, const CanopenProfile& profile)
    : SamplingDevice(setup),
      profile_(profile),
      node_(node_of(setup)),
      serial_number_(identity_of(setup.config)),
      memory_(setup.memory),
      tpdos_(
          {CanopenPdos::Direction::sent, node_, profile.sends, profile.sendable, type_of(setup)}),
      rpdos_({CanopenPdos::Direction::taken, node_, profile.takes, profile.takeable}),
      sdo_(node_),
      next_heartbeat_(setup.boot) {
  recall();
}

std::optional<Stamp> CanopenDevice::deadline() const {
  auto next = any_at_samples(tpdos_) ? SamplingDevice::deadline() : std::optional<Stamp>{};
  if (synced_) next = measurement::earlier(next, *synced_ + latency());
  if (const auto event = schedule_.next_event())
    next = measurement::earlier(next, *event + latency());
  next = measurement::earlier(next, life_.deadline());
  return measurement::earlier(next, next_heartbeat_);
}

void CanopenDevice::tick(Stamp now, Wire& out) {
  if (next_heartbeat_ && *next_heartbeat_ <= now) beat(now, out);
  mind_master(now, out);
  if (synced_ && *synced_ + latency() <= now) {
    chosen_ = schedule_.on_sync(tpdos_);
    take(*std::exchange(synced_, std::nullopt), out);
  }
  for (auto event = schedule_.next_event(); event && *event + latency() <= now;
       event = schedule_.next_event()) {
    chosen_ = schedule_.at_events(tpdos_, *event);
    take(*event, out);
  }
  chosen_ = CanopenSchedule::at_samples(tpdos_);
  if (any_at_samples(tpdos_)) SamplingDevice::tick(now, out);
}

void CanopenDevice::sample(Stamp at, Wire& out) {
  if (!is_operational()) return;
  measure(at, out);
  const auto sent = schedule_.sent(tpdos_, chosen_, at);
  for (std::size_t i = 0; i < tpdos_.size(); ++i)
    if (sent[i]) out.send(filled(tpdos_[i]));
}

wire::CanFrame CanopenDevice::filled(const CanopenPdo& pdo) const {
  wire::CanFrame frame;
  frame.id = pdo.id();
  for (std::size_t i = 0; i < pdo.objects; ++i) {
    const std::uint32_t mapped = pdo.mapping[i];
    const auto found =
        find({static_cast<std::uint16_t>(mapped >> 16), static_cast<std::uint8_t>(mapped >> 8)});
    for (unsigned bit = 0; bit < (mapped & 0xFF); bit += 8)
      frame.data[frame.size++] =
          static_cast<std::uint8_t>(found ? found->value >> bit : std::uint32_t{});
  }
  return frame;
}

void CanopenDevice::receive(const wire::CanFrame& frame, Stamp now, Wire& out) {
  if (state_ == NodeState::boot_up) return;
  if (const auto order = canopen::decode_nmt(frame)) return obey(*order, now, out);
  if (asks_for(frame, canopen::heartbeat_base + node_)) return answer_guarding(now, out);
  if (frame.remote) return;
  if (const auto heartbeat = canopen::decode_heartbeat(frame)) {
    const bool watched = heartbeat->node == settings_.watched_node();
    if (watched && life_.hear_heartbeat(settings_, now)) find_master(out);
  }
  if (state_ == NodeState::stopped) return;
  if (sdo_.receive(frame, *this, now, out) || !is_operational() || frame.extended || frame.error)
    return;
  if (frame.id == settings_.sync_id) return hear_sync(now, out);
  hear_pdo(frame, now, out);
}

void CanopenDevice::hear_sync(Stamp now, Wire& out) {
  if (any_synchronous(tpdos_)) synced_ = now;
  for (std::size_t i = 0; i < rpdos_.size(); ++i)
    if (const auto frame = std::exchange(waiting_[i], std::nullopt))
      take_pdo(rpdos_[i], *frame, now, out);
}

void CanopenDevice::hear_pdo(const wire::CanFrame& frame, Stamp now, Wire& out) {
  for (std::size_t i = 0; i < rpdos_.size(); ++i) {
    if (!rpdos_[i].is_on() || frame.id != rpdos_[i].id()) continue;
    if (rpdos_[i].is_synchronous()) {
      waiting_[i] = frame;
    } else {
      take_pdo(rpdos_[i], frame, now, out);
    }
  }
}

/// A PDO that is shorter than its mapping is not taken; of a longer one the rest means nothing.
void CanopenDevice::take_pdo(const CanopenPdo& pdo, const wire::CanFrame& frame, Stamp now,
                             Wire& out) {
  if (frame.size * 8u < pdo.bits()) {
    if (fault_ == 0) set_fault(sdo::pdo_too_short, sdo::communication_error, out);
    return;
  }
  if (fault_ == sdo::pdo_too_short) set_fault(0, 0, out);
  std::size_t place = 0;
  for (std::size_t i = 0; i < pdo.objects; ++i) {
    const std::uint32_t mapped = pdo.mapping[i];
    std::uint32_t value = 0;
    for (unsigned bit = 0; bit < (mapped & 0xFF); bit += 8)
      value |= std::uint32_t{frame.data[place++]} << bit;
    const Entry entry{static_cast<std::uint16_t>(mapped >> 16),
                      static_cast<std::uint8_t>(mapped >> 8)};
    if (takes(entry)) put(entry, value);  // the rest is for other nodes
  }
  act(now, out);
}

void CanopenDevice::set_fault(std::uint16_t code, std::uint8_t error_register, Wire& out) {
  if (code == fault_) return;
  fault_ = code;
  error_register_ = error_register;
  if (code != 0) errors_.add(code);
  const bool speaks =
      state_ != NodeState::stopped && (settings_.emergency_id & CanopenSettings::invalid_bit) == 0;
  if (!speaks) return;
  auto frame = canopen::encode(canopen::Emergency{node_, code, error_register, {}});
  frame.id = settings_.emergency_id & CanopenSettings::id_bits;
  out.send(frame);
}

}  // namespace drydock::emulate

#include "hil/fault/rogue_node.hpp"

#include <algorithm>

#include "drivers/measurement/earlier.hpp"
#include "hil/emulate/can/j1939_node.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::fault {

namespace {

// linux/can/error.h
constexpr std::uint32_t bus_off_class = 0x040, restarted = 0x100;
constexpr std::uint8_t single_bit_error = 0x01;
constexpr std::size_t type_of_violation = 2;

/// A NAME that wins every contention: function, system, industry group and the highest bit are 0.
/// Two thieves on a bus differ in it, as a NAME holds one address: with one NAME for both, a device
/// that loses its address to the one would go back to that of the other, without an end.
std::uint64_t strongest_name(std::uint32_t identity_of_victim) {
  constexpr unsigned behind_the_identity = 21;
  return std::uint64_t{identity_of_victim} << behind_the_identity | 1;
}

wire::CanFrame error_frame(std::uint32_t error_class) {
  wire::CanFrame frame;
  frame.id = error_class;
  frame.error = true;
  frame.size = 8;
  if (error_class == protocol_violation) frame.data[type_of_violation] = single_bit_error;
  return frame;
}

/// Eight bytes for an identifier that no device here uses.
wire::CanFrame strange_frame(std::uint32_t id, sensor::RandomStream& random) {
  wire::CanFrame frame;
  frame.id = id;
  frame.size = 8;
  for (std::size_t i = 0; i < frame.size; ++i)
    frame.data.at(i) = static_cast<std::uint8_t>(random.next());
  return frame;
}

/// ISO 11898-1: standard frame, eight bytes, three bits of space. Stuff bits are left out, so that
/// a babbling node always has a frame waiting.
constexpr double bits_of_frame = 111;

constexpr std::uint32_t highest_priority = 0x000, lowest_priority = 0x7FF;

}  // namespace

RogueNode::RogueNode(const rig_config::DeviceConfig& config, unsigned bit_rate, std::uint64_t seed,
                     Stamp start, std::shared_ptr<const Schedule> schedule)
    : bit_rate_(bit_rate),
      protocol_(config.protocol),
      identity_(emulate::identity_of(config)),
      random_(seed, config.name, "rogue"),
      schedule_(std::move(schedule), start),
      beats_{Beat{FaultKind::babbling}, Beat{FaultKind::bus_load}, Beat{FaultKind::error_frames}} {
  if (config.address != 0) address_ = static_cast<std::uint8_t>(config.address);
}

std::optional<Stamp> RogueNode::deadline() const {
  auto next = schedule_.deadline();
  for (const Beat& beat : beats_)
    if (beat.period.count() > 0) next = measurement::earlier(next, beat.next);
  if (claim_) next = measurement::earlier(next, std::optional<Stamp>(claim_->deadline()));
  return next;
}

void RogueNode::tick(Stamp now, emulate::Wire& out) {
  follow_schedule(now, out);
  for (Beat& beat : beats_) {
    if (beat.period.count() == 0) continue;
    for (; beat.next <= now; beat.next += beat.period) strike(beat, out);
  }
  if (claim_ && claim_->deadline() && *claim_->deadline() <= now.time_since_epoch())
    if (const auto frame = claim_->tick(now.time_since_epoch())) out.send(*frame);
}

void RogueNode::follow_schedule(Stamp now, emulate::Wire& out) {
  const auto faults = schedule_.changed(now);
  if (!faults) return;
  for (Beat& beat : beats_) set_beat(beat, find(*faults, beat.kind), now);
  go_bus_off(find(*faults, FaultKind::bus_off) != nullptr, out);
  steal_address(find(*faults, FaultKind::address_stolen) != nullptr, now, out);
}

void RogueNode::set_beat(Beat& beat, const InForce* fault, Stamp now) {
  const auto period = fault ? period_of(*fault->fault) : std::chrono::nanoseconds{0};
  if (beat.period.count() == 0) beat.next = now;
  beat.period = period;
}

std::chrono::nanoseconds RogueNode::period_of(const FaultConfig& fault) const {
  if (fault.kind == FaultKind::error_frames) return measurement::from_seconds(1 / fault.amount[0]);
  const double frame_s = bits_of_frame / static_cast<double>(bit_rate_);
  const double share = fault.kind == FaultKind::babbling ? 1 : fault.amount[0];
  return measurement::from_seconds(frame_s / share);
}

void RogueNode::strike(const Beat& beat, emulate::Wire& out) {
  switch (beat.kind) {
    case FaultKind::babbling: return out.send(strange_frame(highest_priority, random_));
    case FaultKind::bus_load: return out.send(strange_frame(lowest_priority, random_));
    default: return out.send(error_frame(protocol_violation));
  }
}

void RogueNode::go_bus_off(bool off, emulate::Wire& out) {
  if (off == bus_off_) return;
  bus_off_ = off;
  if (off) {
    out.send(error_frame(bus_off_class));
    out.unplug();
  } else {
    out.plug();
    out.send(error_frame(restarted));
  }
}

void RogueNode::steal_address(bool wanted, Stamp now, emulate::Wire& out) {
  if (wanted == steals_) return;
  steals_ = wanted;
  claim_.reset();
  if (wanted && address_) claim_address(now, out);
}

void RogueNode::claim_address(Stamp now, emulate::Wire& out) {
  claim_.emplace(strongest_name(identity_), *address_,
                 wire::j1939::AddressRange{*address_, *address_});
  if (const auto frame = claim_->start(now.time_since_epoch())) out.send(*frame);
}

/// The address that the device's NAME claimed last.
void RogueNode::note_address(const wire::CanFrame& frame) {
  const auto id = wire::j1939::identify(frame);
  if (!id || id->pgn != wire::j1939::address_claim_pgn) return;
  const auto claim = wire::j1939::decode_address_claimed(*id, frame.payload());
  if (!claim || claim->source == wire::j1939::null_address) return;
  if (emulate::identity_in(claim->name, protocol_) == identity_) address_ = claim->source;
}

void RogueNode::receive(const wire::CanFrame& frame, Stamp now, emulate::Wire& out) {
  note_address(frame);
  if (steals_ && !claim_ && address_) return claim_address(now, out);
  if (!claim_) return;
  if (const auto answer = claim_->receive(frame, now.time_since_epoch())) out.send(*answer);
}

}  // namespace drydock::fault

#include "drivers/survey/bus_listener.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "drivers/wire/canopen/canopen_sdo.hpp"
#include "drivers/wire/j1939/aceinna.hpp"
#include "drivers/wire/j1939/mv5.hpp"
#include "drivers/wire/protocols.hpp"

namespace drydock::survey {
namespace {

using wire::CanFrame;

constexpr std::uint32_t sdo_answer_base = 0x580;

wire::Network network_of(NodeKind kind) {
  switch (kind) {
    case NodeKind::j1939: return wire::Network::j1939;
    case NodeKind::canopen: return wire::Network::canopen;
    case NodeKind::plain:
    case NodeKind::described: break;
  }
  return wire::Network::none;
}

/// The protocols with a driver that such a node can speak, in the order of the table.
std::vector<std::string_view> protocols_on(NodeKind kind) {
  std::vector<std::string_view> names;
  for (const wire::Protocol& protocol : wire::protocols())
    if (protocol.travels == wire::Travels::as_frames && protocol.network == network_of(kind) &&
        !protocol.kinds.empty())
      names.push_back(protocol.name);
  return names;
}

bool is_tpdo1(const CanFrame& frame) {
  return wire::canopen::node_above(frame, wire::canopen::tpdo_id(1, 0)).has_value();
}

std::string reads_too(const DriverTrial& trial) {
  return fmt::format("{} reads {} measurements of kind {} in the same frames", trial.protocol(),
                     trial.measurements(), to_string(trial.kind()));
}

}  // namespace

BusListener::BusListener(NodeKind kind, std::uint8_t address, const Descriptions& descriptions) {
  node_.kind = kind;
  node_.address = address;
  for (const auto& one : descriptions)
    if (kind == NodeKind::j1939) described_.push_back(std::make_unique<DescribedTrial>(one));
  for (const auto protocol : protocols_on(kind))
    for (auto& trial : trials_of(protocol, address)) trials_.push_back({std::move(trial), {}});
}

void BusListener::receive(const CanFrame& frame, Stamp at) {
  ++node_.frames;
  const BusId from{frame.id, frame.extended};
  heard_[from].add(at);
  if (const auto id = wire::j1939::identify(frame)) hear_claim(*id, frame);
  if (node_.kind == NodeKind::canopen) hear_services(frame);
  if (is_tpdo1(frame)) widest_tpdo1_ = std::max(widest_tpdo1_, frame.size);
  for (auto& trial : described_) trial->receive(frame, at);
  for (auto& trial : trials_) {
    const auto before = trial.driver->measurements();
    trial.driver->receive(frame, at);
    const auto made = trial.driver->measurements() - before;
    if (made > 0) trial.completed[from] += made;
  }
}

void BusListener::hear_claim(const wire::j1939::Identifier& id, const CanFrame& frame) {
  const auto claim = wire::j1939::decode_address_claimed(id, frame.payload());
  if (!claim) return;
  node_.name = wire::j1939::to_name(claim->name);
  reversed_name_ = wire::aceinna::to_name(claim->name);
}

void BusListener::hear_services(const CanFrame& frame) {
  if (const auto beat = wire::canopen::decode_heartbeat(frame)) {
    node_.state = beat->state;
    node_.booted |= beat->state == wire::canopen::NodeState::boot_up;
  }
  if (const auto trouble = wire::canopen::decode_emergency(frame)) node_.emergency = trouble;
  const auto answer = wire::canopen::decode_sdo_response(frame);
  const auto* value = answer ? std::get_if<wire::canopen::SdoValue>(&*answer) : nullptr;
  if (answer) node_.answered = true;
  if (value == nullptr) return;
  if (value->entry == wire::canopen::ObjectEntry{0x1000, 0}) node_.device_type = value->value;
  if (value->entry == wire::canopen::ObjectEntry{0x1018, 1}) node_.vendor_id = value->value;
  if (value->entry == wire::canopen::ObjectEntry{0x1018, 2}) node_.product_code = value->value;
}

Node BusListener::node(const IsTaken& is_taken) const {
  Node node = node_;
  std::map<std::uint32_t, Arrivals> traffic;
  for (const auto& [id, arrivals] : heard_) {
    const bool by_group = node.kind == NodeKind::j1939;
    traffic[by_group ? wire::j1939::parse_identifier(id.id).pgn : id.id].add(arrivals);
  }
  for (const auto& [number, arrivals] : traffic)
    node.traffic.push_back({number, arrivals.count, arrivals.rate_hz()});
  forget_taken_services(is_taken, node);
  choose_sensors(is_taken, node);
  return node;
}

/// What a description explains is no heartbeat, emergency or answer.
void BusListener::forget_taken_services(const IsTaken& is_taken, Node& node) const {
  if (node.kind != NodeKind::canopen) return;
  const auto taken = [&](std::uint32_t base) { return is_taken({base + node.address, false}); };
  if (taken(wire::canopen::heartbeat_base)) node.state.reset(), node.booted = false;
  if (taken(wire::canopen::emergency_base)) node.emergency.reset();
  if (!taken(sdo_answer_base)) return;
  node.answered = false;
  node.device_type = node.vendor_id = node.product_code = std::nullopt;
}

/// Layouts overlap on 11-bit identifiers: if both an IMU and a transmitter can decode the same
/// TPDO1, only one is right. A pressure occupies 4 or 5 bytes, or is alone; an IMU fills 8 bytes
/// and more than one PDO. Therefore an IMU with plausible values comes first. A description that
/// fits was asked for: it comes before the registry.
void BusListener::choose_sensors(const IsTaken& is_taken, Node& node) const {
  bool any = false;
  for (const auto kind : measurement::kinds) {
    const bool second_reading = node.kind == NodeKind::canopen && any;
    const bool too_wide =
        node.kind == NodeKind::canopen && kind == Kind::depth && widest_tpdo1_ > 5;
    if (second_reading || too_wide) continue;
    const DescribedTrial* described = best_described(kind);
    const DriverTrial* own = best_of(kind, is_taken, false);
    const DriverTrial* taken = best_of(kind, is_taken, true);
    any = any || described || own || taken;
    if (described && own) node.also.push_back(reads_too(*own));
    if (taken) node.also.push_back(reads_too(*taken));
    if (described) {
      node.sensors.push_back(described->heard());
      node.confidence = std::max(
          node.confidence, described->is_certain() ? Confidence::certain : Confidence::likely);
    } else if (own) {
      constexpr std::uint64_t enough = 5;
      const bool certain = own->measurements() >= enough && own->counters().bad_checksums == 0;
      node.sensors.push_back(own->heard());
      node.confidence =
          std::max(node.confidence, certain ? Confidence::certain : Confidence::likely);
      if (own->protocol() == wire::Aceinna::name && reversed_name_) node.name = reversed_name_;
    }
  }
}

const DescribedTrial* BusListener::best_described(Kind kind) const {
  const DescribedTrial* best = nullptr;
  for (const auto& trial : described_) {
    if (trial->driver().kind() != kind || !trial->is_found()) continue;
    if (best == nullptr || better_of(&best->driver(), &trial->driver()) == &trial->driver())
      best = trial.get();
  }
  return best;
}

/// Of the drivers whose frames are all taken, or of the others.
const DriverTrial* BusListener::best_of(Kind kind, const IsTaken& is_taken, bool taken) const {
  const DriverTrial* best = nullptr;
  for (const auto& trial : trials_)
    if (trial.driver->kind() == kind && trial.is_taken(is_taken) == taken &&
        may_speak(trial.driver->protocol()))
      best = better_of(best, trial.driver.get());
  return best;
}

bool BusListener::RegistryTrial::is_taken(const IsTaken& taken) const {
  return !completed.empty() &&
         std::ranges::all_of(completed, [&](const auto& one) { return taken(one.first); });
}

/// Two makers send the same fields in other axes. The NAME tells them apart, or without one the
/// address that the MV5 has when delivered.
bool BusListener::may_speak(std::string_view protocol) const {
  const bool is_mv5 = node_.name ? node_.name->manufacturer_code == wire::mv5::manufacturer
                                 : node_.address == wire::mv5::default_address;
  if (protocol == wire::Mv5::name) return is_mv5;
  return protocol != wire::Aceinna::name || !is_mv5;
}

}  // namespace drydock::survey

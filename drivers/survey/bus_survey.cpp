#include "drivers/survey/bus_survey.hpp"

#include <algorithm>
#include <span>

#include "drivers/device/bus/can_error_text.hpp"
#include "drivers/survey/arrivals.hpp"
#include "drivers/wire/can/can_bits.hpp"
#include "drivers/wire/canopen/canopen_sdo.hpp"
#include "drivers/wire/j1939/aceinna.hpp"
#include "drivers/wire/j1939/mv5.hpp"
#include "drivers/wire/protocols.hpp"

namespace drydock::survey {
namespace {

using wire::CanFrame;

constexpr std::uint32_t last_canopen_id = 0x77F, node_bits = 0x7F;
constexpr unsigned function_shift = 7, time_function = 2;

/// The predefined connection set of CiA 301 gives every node identifiers function << 7 | node.
/// Lower identifiers are broadcasts and Xsens's messages. Function 2 is the broadcast 100h alone:
/// the others of its identifiers are SBG's.
bool is_canopen(const CanFrame& frame) {
  return !frame.extended && frame.id > wire::canopen::sync_id && frame.id <= last_canopen_id &&
         (frame.id & node_bits) != 0 && frame.id >> function_shift != time_function;
}

std::pair<NodeKind, std::uint8_t> sender(const CanFrame& frame) {
  if (const auto id = wire::j1939::identify(frame)) return {NodeKind::j1939, id->source};
  if (is_canopen(frame))
    return {NodeKind::canopen, static_cast<std::uint8_t>(frame.id & node_bits)};
  return {NodeKind::plain, 0};
}

wire::Network network_of(NodeKind kind) {
  switch (kind) {
    case NodeKind::j1939: return wire::Network::j1939;
    case NodeKind::canopen: return wire::Network::canopen;
    case NodeKind::plain: break;
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

}  // namespace

/// One sender: its traffic, its reports about itself, and every driver tried on it.
class BusSurvey::Listener {
 public:
  Listener(NodeKind kind, std::uint8_t address, const Descriptions& descriptions) {
    node_.kind = kind;
    node_.address = address;
    for (const auto& one : descriptions)
      if (one->frames && one->facts.network == network_of(kind))
        std::ranges::move(trials_of(one), std::back_inserter(trials_));
    described_ = trials_.size();
    for (const auto protocol : protocols_on(kind))
      std::ranges::move(trials_of(protocol, address), std::back_inserter(trials_));
  }

  void receive(const CanFrame& frame, Stamp at) {
    ++node_.frames;
    const auto id = wire::j1939::identify(frame);
    heard_[id ? id->pgn : frame.id].add(at);
    if (id) hear_claim(*id, frame);
    if (node_.kind == NodeKind::canopen) hear_services(frame);
    if (is_tpdo1(frame)) widest_tpdo1_ = std::max(widest_tpdo1_, frame.size);
    for (auto& trial : trials_) trial->receive(frame, at);
  }

  Node node() const {
    Node node = node_;
    for (const auto& [number, arrivals] : heard_)
      node.traffic.push_back({number, arrivals.count, arrivals.rate_hz()});
    choose_sensors(node);
    return node;
  }

 private:
  static bool is_tpdo1(const CanFrame& frame) {
    return wire::canopen::node_above(frame, wire::canopen::tpdo_id(1, 0)).has_value();
  }

  void hear_claim(const wire::j1939::Identifier& id, const CanFrame& frame) {
    const auto claim = wire::j1939::decode_address_claimed(id, frame.payload());
    if (!claim) return;
    node_.name = wire::j1939::to_name(claim->name);
    reversed_name_ = wire::aceinna::to_name(claim->name);
  }

  void hear_services(const CanFrame& frame) {
    if (const auto beat = wire::canopen::decode_heartbeat(frame)) {
      node_.state = beat->state;
      node_.booted |= beat->state == wire::canopen::NodeState::boot_up;
    }
    if (const auto trouble = wire::canopen::decode_emergency(frame)) node_.emergency = trouble;
    const auto answer = wire::canopen::decode_sdo_response(frame);
    const auto* value = answer ? std::get_if<wire::canopen::SdoValue>(&*answer) : nullptr;
    if (value == nullptr) return;
    if (value->entry == wire::canopen::ObjectEntry{0x1000, 0}) node_.device_type = value->value;
    if (value->entry == wire::canopen::ObjectEntry{0x1018, 1}) node_.vendor_id = value->value;
    if (value->entry == wire::canopen::ObjectEntry{0x1018, 2}) node_.product_code = value->value;
  }

  /// Layouts overlap on 11-bit identifiers: if both an IMU and a transmitter can decode the same
  /// TPDO1, only one is right. A pressure occupies 4 or 5 bytes, or is alone; an IMU fills 8 bytes
  /// and more than one PDO. Therefore an IMU with plausible values comes first.
  void choose_sensors(Node& node) const {
    std::vector<const DriverTrial*> good;
    for (const auto kind : measurement::kinds) {
      const DriverTrial* best = best_of(kind);
      if (best == nullptr) continue;
      const bool second_reading = node.kind == NodeKind::canopen && !good.empty();
      const bool too_wide =
          node.kind == NodeKind::canopen && kind == Kind::depth && widest_tpdo1_ > 5;
      if (!second_reading && !too_wide) good.push_back(best);
    }
    for (const auto* sensor : good) {
      node.sensors.push_back(sensor->heard());
      constexpr std::uint64_t enough = 5;
      const bool certain =
          sensor->measurements() >= enough && sensor->counters().bad_checksums == 0;
      const auto confidence = certain ? Confidence::certain : Confidence::likely;
      node.confidence = std::max(node.confidence, confidence);
      if (sensor->protocol() == wire::Aceinna::name && reversed_name_) node.name = reversed_name_;
    }
  }

  /// A description that fits was asked for: it comes before the registry.
  const DriverTrial* best_of(Kind kind) const {
    const auto trials = std::span(trials_);
    const DriverTrial* asked_for = best_of(kind, trials.first(described_));
    return asked_for ? asked_for : best_of(kind, trials.subspan(described_));
  }

  const DriverTrial* best_of(Kind kind,
                             std::span<const std::unique_ptr<DriverTrial>> trials) const {
    const DriverTrial* best = nullptr;
    for (const auto& trial : trials)
      if (trial->kind() == kind && may_speak(trial->protocol()))
        best = better_of(best, trial.get());
    return best;
  }

  /// Two makers send the same fields in other axes. The NAME tells them apart, or without one the
  /// address that the MV5 has when delivered.
  bool may_speak(std::string_view protocol) const {
    const bool is_mv5 = node_.name ? node_.name->manufacturer_code == wire::mv5::manufacturer
                                   : node_.address == wire::mv5::default_address;
    if (protocol == wire::Mv5::name) return is_mv5;
    return protocol != wire::Aceinna::name || !is_mv5;
  }

  Node node_;
  std::map<std::uint32_t, Arrivals> heard_;
  std::optional<wire::j1939::Name> reversed_name_;  ///< in the order of Aceinna's fields
  std::uint8_t widest_tpdo1_ = 0;
  std::vector<std::unique_ptr<DriverTrial>> trials_;
  std::size_t described_ = 0;  ///< the first of the trials are those of descriptions
};

BusSurvey::BusSurvey(Descriptions descriptions) : descriptions_(std::move(descriptions)) {}
BusSurvey::~BusSurvey() = default;

BusSurvey::Listener& BusSurvey::listener_of(const CanFrame& frame) {
  const auto key = sender(frame);
  auto& listener = listeners_[key];
  if (!listener) listener = std::make_unique<Listener>(key.first, key.second, descriptions_);
  return *listener;
}

void BusSurvey::receive(const CanFrame& frame, Stamp at) {
  if (frame.error) {
    ++complaints_[std::string(device::can_error_text(frame))];
    return;
  }
  ++frames_;
  if (!first_) first_ = at;
  if (at > *first_) bits_ += wire::wire_bits(frame);  // the time begins with the first frame
  last_ = at;
  listener_of(frame).receive(frame, at);
}

std::vector<Node> BusSurvey::nodes() const {
  std::vector<Node> nodes;
  for (const auto& [key, listener] : listeners_) nodes.push_back(listener->node());
  return nodes;
}

std::vector<Complaint> BusSurvey::complaints() const {
  std::vector<Complaint> all;
  for (const auto& [text, frames] : complaints_) all.push_back({text, frames});
  return all;
}

std::optional<double> BusSurvey::bits_per_second() const {
  if (!first_ || last_ <= *first_) return {};
  return static_cast<double>(bits_) / measurement::seconds(last_ - *first_);
}

std::string bit_rate_hint(const std::vector<Complaint>& complaints, std::uint64_t frames) {
  if (!complaints.empty() && frames == 0)
    return "error frames and nothing else: the bit rate is wrong, or the wiring (CAN high and low, "
           "120 ohm at both ends)";
  if (frames == 0)
    return "silence: nobody sends, or the cable is not connected; a listening node sees no error "
           "then";
  return {};
}

}  // namespace drydock::survey

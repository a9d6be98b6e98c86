#include "drivers/diagnosis/monitors/bus_monitor.hpp"

#include <algorithm>
#include <utility>

#include "drivers/diagnosis/monitors/bus_management.hpp"
#include "drivers/wire/can/can_bits.hpp"
#include "drivers/wire/j1939/j1939.hpp"

namespace drydock::diagnosis {
namespace {

// linux/can/error.h
constexpr std::uint32_t bus_off_class = 0x040;

/// A bus is taken if what was not there before has this share of its bits. The rest of a sound bus
/// grows by less when a node joins.
constexpr double largest_new_share = 0.2;
constexpr std::chrono::milliseconds load_window{500};
/// A bus without a pause for so long holds frames up.
constexpr std::chrono::milliseconds long_busy{3};
/// A slope is that of some blocks, and is told for a while.
constexpr auto slope_memory = RateWatch::block * (RateWatch::blocks + 2);

}  // namespace

BusMonitor::BusMonitor(const std::vector<Expected>& devices, SymptomSink& to) {
  for (const Expected& expected : devices)
    nodes_.push_back({expected, {expected.device, to}, {expected, to}});
}

void BusMonitor::take(const wire::CanFrame& frame, Stamp at, HostLate host) {
  host_ = host;
  if (!first_) {
    first_ = at;
    window_from_ = at;
  }
  if (frame.error) return take_error(frame, at);
  note_deafness(at);
  note_busy(frame, at);
  off_ = false;
  if (addresses_.take(frame, at)) excuse_robbed();
  take_data(frame, at);
}

/// A node that had to leave its address is known under it.
void BusMonitor::take_data(const wire::CanFrame& frame, Stamp at) {
  const std::uint32_t id = addresses_.id_at_home(frame);
  if (id == frame.id) return judge_identifier(frame, at);
  wire::CanFrame at_home = frame;
  at_home.id = id;
  judge_identifier(at_home, at);
}

/// Where it has several nodes none of them is to blame, and what they would have said meanwhile is
/// not missing. What is usual is learned from time that
/// was heard.
void BusMonitor::note_deafness(Stamp at) {
  if (last_ == Stamp{}) return;
  const double pause_s = measurement::seconds(at - last_);
  if (!silence_.is_deaf(pause_s)) return;
  if (last_ - *first_ < learning) *first_ += at - last_;
  if (nodes_.size() > 1)
    for (Node& node : nodes_) node.frames.excuse_pause();
}

void BusMonitor::note_busy(const wire::CanFrame& frame, Stamp at) {
  const double frame_s = static_cast<double>(wire::wire_bits(frame)) / bitrate_;
  const double pause_s = measurement::seconds(at - last_) - frame_s;
  last_ = at;
  ++busy_frames_;
  if (pause_s <= frame_s) return;
  busy_since_ = at - measurement::from_seconds(frame_s);
  busy_frames_ = 1;
  for (Node& node : nodes_) node.busy_frames = 0;
}

void BusMonitor::take_error(const wire::CanFrame& frame, Stamp at) {
  const bool off = (frame.id & bus_off_class) != 0;
  if (off && !off_) off_since_ = at;
  off_ = off;
}

/// A rig that states no address takes the node that sends; two such devices cannot be told apart.
const BusMonitor::Node* BusMonitor::node_at(std::uint8_t address) const {
  const Node* unstated = nullptr;
  for (const Node& node : nodes_) {
    if (node.expected.protocol.network != wire::Network::j1939) continue;
    if (node.expected.address == address) return &node;
    if (node.expected.address != 0) continue;
    if (unstated != nullptr) return nullptr;
    unstated = &node;
  }
  return sends_from(address) ? unstated : nullptr;
}

/// Another NAME claims its address since then.
std::optional<Stamp> BusMonitor::robbed_since(const Node& node) const {
  if (node.expected.protocol.network != wire::Network::j1939) return {};
  for (const auto& owner : addresses_.owners())
    if (owner.lost && addresses_.owner_of(owner.home) == &owner && node_at(owner.home) == &node)
      return owner.lost;
  return {};
}

bool BusMonitor::sends_from(std::uint8_t address) const {
  return std::ranges::any_of(usual_, [&](const Usual& usual) {
    const auto identifier = wire::j1939::parse_identifier(usual.key);
    return identifier.source == address && identifier.pgn != wire::j1939::address_claim_pgn &&
           identifier.pgn != wire::j1939::request_pgn;
  });
}

/// A sound node has more to say than in its first seconds: NMEA 2000's heartbeat comes once a
/// minute, and an alarm when there is one. Noise has any sender.
bool BusMonitor::has_a_known_sender(const wire::CanFrame& frame) const {
  return frame.extended && sends_from(wire::j1939::parse_identifier(frame.id).source) &&
         std::ranges::any_of(nodes_, [](const Node& node) {
           return node.expected.protocol.network == wire::Network::j1939;
         });
}

void BusMonitor::judge_identifier(const wire::CanFrame& frame, Stamp at) {
  if (!is_usual(frame, at)) {
    new_bits_ += wire::wire_bits(frame);
    if (!strange_.is_repeated(key_of(frame)) && !has_a_known_sender(frame)) note_strange(at);
    return;
  }
  if (strange_.come_before(at))
    if (Node* node = owner_of(frame)) ++node->follows_strange;
}

bool BusMonitor::is_usual(const wire::CanFrame& frame, Stamp at) {
  if (Usual* const usual = usual_.find(key_of(frame))) {
    judge_size(*usual, frame, at);
    watch_times(*usual, frame, at);
    return true;
  }
  if (at - *first_ < learning) usual_.add(frame);
  if (usual_.too_many() || at - *first_ < learning) return true;
  return std::ranges::any_of(
      nodes_, [&](const Node& node) { return manages(frame, node.expected.protocol.network); });
}

void BusMonitor::judge_size(Usual& usual, const wire::CanFrame& frame, Stamp at) {
  if (at - *first_ < learning) usual.sizes |= size_bit(frame);
  if ((usual.sizes & size_bit(frame)) != 0) return;
  const Amount amount{static_cast<double>(frame.size), 8, "bytes of a frame that had others", "B"};
  if (const Node* node = owner_of(frame))
    return node->teller.tell(Sign::bad_checksums, at, at, amount);
  tell_all(Sign::bad_checksums, at, at, amount);
}

void BusMonitor::watch_times(Usual& usual, const wire::CanFrame& frame, Stamp at) {
  const std::uint64_t data = first_bytes_of(frame);
  const bool same = std::exchange(usual.data, data) == data;
  measurement::Origin origin;
  origin.received_at = origin.valid_at = at;
  Node* const node = owner_of(frame);
  if (node == nullptr) return;
  ++node->busy_frames;
  const bool by_others = 2 * node->busy_frames < busy_frames_;
  const auto busy = at - busy_since_;
  if (at - *first_ < learning) usual_busy_ = std::max(usual_busy_, busy);
  const bool unusual = busy > std::max<std::chrono::nanoseconds>(long_busy, usual_busy_ * 3 / 2);
  const bool now = busy > long_busy;
  const double by_others_s = by_others ? measurement::seconds(busy) : 0;
  node->frames.take(usual.key, origin, same,
                    {.now = now,
                     .waits_s = now ? by_others_s : 0,
                     .held_s = unusual ? by_others_s : 0,
                     .host = host_});
}

void BusMonitor::note_strange(Stamp at) {
  if (!strange_.note(at)) return;
  for (Node& node : nodes_) node.follows_strange = 0;
}

BusMonitor::Node* BusMonitor::owner_of(const wire::CanFrame& frame) {
  if (nodes_.size() == 1) return &nodes_.front();
  for (Node& node : nodes_) {
    const std::uint8_t address = node.expected.address;
    const wire::Network network = node.expected.protocol.network;
    if (address == 0) continue;
    if (network == wire::Network::j1939 && frame.extended && (frame.id & 0xFF) == address)
      return &node;
    if (network == wire::Network::canopen && !frame.extended && (frame.id & 0x7F) == address)
      return &node;
  }
  return nullptr;
}

void BusMonitor::look(Stamp now) {
  if (!first_) return;
  for (Node& node : nodes_) node.frames.look(now);
  look_at_drift(now);
  if (off_) tell_all(Sign::bus_off, off_since_, now, {1, 0, "bus-off", ""});
  addresses_.look(now);
  for (const Node& node : nodes_)
    if (const auto since = robbed_since(node))
      node.teller.tell(Sign::address_taken, *since, now,
                       {2, 1, "NAMEs that claim its address", ""});
  if (now - window_from_ >= load_window) look_at_load(now);
  look_at_strange(now);
}

void BusMonitor::look_at_load(Stamp now) {
  const double could = measurement::seconds(now - window_from_) * bitrate_;
  const double share = new_bits_ / could;
  if (share > largest_new_share)
    tell_all(Sign::bus_taken, window_from_, now,
             {share, largest_new_share, "share of the bus of new identifiers", ""});
  window_from_ = now;
  new_bits_ = 0;
}

/// A node that drifts pushes the frames of others about: the first that drifts is the one. What it
/// did to them stays in their slopes for a while.
void BusMonitor::look_at_drift(Stamp now) {
  if (drifts_ != nullptr && !drifts_->frames.drift(now)) drifts_ = nullptr;
  for (Node& node : nodes_)
    if (drifts_ == nullptr && now >= node.pushed_until && node.frames.drift(now)) drifts_ = &node;
  if (drifts_ == nullptr) return;
  for (Node& node : nodes_)
    if (&node != drifts_) node.pushed_until = now + slope_memory;
  drifts_->teller.tell(Sign::clock_drift, drifts_->frames.drift_since(), now,
                       *drifts_->frames.drift(now));
}

void BusMonitor::look_at_strange(Stamp now) {
  if (!strange_.are_news()) return;
  const Amount amount{static_cast<double>(strange_.count()), 0, "frames with identifiers seen once",
                      ""};
  // A node that lost its address sends from others.
  const auto robbed = std::ranges::find_if(
      nodes_, [&](const Node& node) { return robbed_since(node).has_value(); });
  if (robbed != nodes_.end())
    return robbed->teller.tell(Sign::strange_frames, strange_.since(), now, amount);
  const auto sender = std::ranges::max_element(nodes_, {}, &Node::follows_strange);
  if (nodes_.size() > 1 && sender->follows_strange * 2 > strange_.count())
    return sender->teller.tell(Sign::strange_frames, strange_.since(), now, amount);
  tell_all(Sign::strange_frames, strange_.since(), now, amount);
}

}  // namespace drydock::diagnosis

#include "drivers/diagnosis/monitors/bus_monitor.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

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
/// Strange frames that come at least so often, and at least so many of them, are no accident.
constexpr std::chrono::seconds strange_pause{10};
constexpr unsigned fewest_strange = 3;
/// The next frame behind a strange one, if it comes so soon, is of the node that sent both.
constexpr std::chrono::milliseconds soon{3};
/// A bus without a pause for so long holds frames up.
constexpr std::chrono::milliseconds long_busy{3};

/// A bus with several nodes that carries nothing for so long, and for so many usual pauses, was not
/// heard: none of its nodes is to blame.
constexpr double shortest_deafness_s = 0.5, deafness_pauses = 20;
constexpr double pause_memory = 64;  // frames

std::uint32_t key_of(const wire::CanFrame& frame) {
  constexpr std::uint32_t extended_bit = 0x80000000;
  return frame.extended ? frame.id | extended_bit : frame.id;
}

std::uint64_t size_bit(const wire::CanFrame& frame) {
  return std::uint64_t{1} << std::min<unsigned>(frame.size, 63);
}

/// Only to be compared: the order of the bytes is the computer's.
std::uint64_t first_bytes_of(const wire::CanFrame& frame) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, frame.data.data(), sizeof bytes);
  return bytes;
}

/// Frames by which nodes settle their addresses and states. They come at any time.
bool manages(const wire::CanFrame& frame, wire::Network network) {
  if (network == wire::Network::j1939) {
    if (!frame.extended) return false;
    const auto pgn = wire::j1939::parse_identifier(frame.id).pgn;
    return pgn == wire::j1939::address_claim_pgn || pgn == wire::j1939::request_pgn;
  }
  // CiA 301: NMT 000h is the only one that a babbling node also uses, so it is none of these.
  const std::uint32_t function = frame.id & 0x780;
  return network == wire::Network::canopen && !frame.extended &&
         (function == 0x080 || function == 0x580 || function == 0x600 || function == 0x700);
}

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
  take_claim(frame, at);
  judge_identifier(frame, at);
}

/// What its nodes would have said meanwhile is not missing. What is usual is learned from time that
/// was heard.
void BusMonitor::note_deafness(Stamp at) {
  if (last_ == Stamp{}) return;
  const double pause_s = measurement::seconds(at - last_);
  const bool long_pause = pause_s > std::max(shortest_deafness_s, deafness_pauses * usual_pause_s_);
  usual_pause_s_ += (std::min(pause_s, shortest_deafness_s) - usual_pause_s_) / pause_memory;
  if (!long_pause) return;
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

void BusMonitor::take_claim(const wire::CanFrame& frame, Stamp at) {
  const auto identifier = wire::j1939::identify(frame);
  if (!identifier || identifier->pgn != wire::j1939::address_claim_pgn || frame.size != 8) return;
  const std::uint64_t name = first_bytes_of(frame);
  const auto first = std::ranges::find(claims_, identifier->source, &Claim::address);
  if (first == claims_.end()) {
    if (claims_.size() < claims_.capacity()) claims_.push_back({identifier->source, name});
    return;
  }
  Node* const node = node_at(identifier->source);
  if (node == nullptr) return;
  const bool robbed = name != first->name;
  if (robbed && !node->robbed) node->robbed_since = at;
  node->robbed = robbed;
}

/// A rig that states no address takes the node that sends; two such devices cannot be told apart.
BusMonitor::Node* BusMonitor::node_at(std::uint8_t address) {
  Node* unstated = nullptr;
  for (Node& node : nodes_) {
    if (node.expected.protocol.network != wire::Network::j1939) continue;
    if (node.expected.address == address) return &node;
    if (node.expected.address != 0) continue;
    if (unstated != nullptr) return nullptr;
    unstated = &node;
  }
  return sends_from(address) ? unstated : nullptr;
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
    // A node that joins repeats its identifiers; noise does not.
    if (!is_repeated(key_of(frame)) && !has_a_known_sender(frame)) note_strange(at);
    return;
  }
  if (behind_strange_ && at - strange_at_ < soon)
    if (Node* node = owner_of(frame)) ++node->follows_strange;
  behind_strange_ = false;
}

/// Frames mostly follow each other as they did the last time. Null: it is not usual.
BusMonitor::Usual* BusMonitor::usual_of(std::uint32_t key) {
  if (usual_.empty()) return nullptr;
  std::size_t& next = usual_[latest_].next;
  if (usual_[next].key != key) {
    const auto found = std::ranges::find(usual_, key, &Usual::key);
    if (found == usual_.end()) return nullptr;
    next = static_cast<std::size_t>(found - usual_.begin());
  }
  latest_ = next;
  return &usual_[next];
}

bool BusMonitor::is_usual(const wire::CanFrame& frame, Stamp at) {
  if (Usual* const usual = usual_of(key_of(frame))) {
    judge_size(*usual, frame, at);
    watch_times(*usual, frame, at);
    return true;
  }
  if (at - *first_ < learning) {
    too_many_ = usual_.size() == usual_.capacity();
    if (!too_many_) usual_.push_back({key_of(frame), size_bit(frame), 0, 0});
  }
  if (too_many_ || at - *first_ < learning) return true;
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
  origin.received_at = at;
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

bool BusMonitor::is_repeated(std::uint32_t key) {
  if (std::ranges::find(recent_, key + 1) != recent_.end()) return true;
  recent_[next_recent_++ % recent_.size()] = key + 1;  // 0 stands for none
  return false;
}

void BusMonitor::note_strange(Stamp at) {
  if (at - strange_at_ > strange_pause) {
    strange_ = 0;
    strange_since_ = at;
    for (Node& node : nodes_) node.follows_strange = 0;
  }
  ++strange_;
  strange_at_ = at;
  behind_strange_ = true;
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
  for (const Node& node : nodes_)
    if (node.robbed)
      node.teller.tell(Sign::address_taken, node.robbed_since, now,
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

/// A node that drifts pushes the frames of others about: the first that drifts is the one.
void BusMonitor::look_at_drift(Stamp now) {
  const bool goes_on = drifts_ != nullptr && drifts_->frames.drift(now);
  if (!goes_on) drifts_ = nullptr;
  for (Node& node : nodes_)
    if (drifts_ == nullptr && node.frames.drift(now)) drifts_ = &node;
  if (drifts_ != nullptr)
    drifts_->teller.tell(Sign::clock_drift, drifts_->frames.drift_since(), now,
                         *drifts_->frames.drift(now));
}

void BusMonitor::look_at_strange(Stamp now) {
  if (strange_ < fewest_strange || strange_ == strange_told_) return;
  strange_told_ = strange_;
  const Amount amount{static_cast<double>(strange_), 0, "frames with identifiers seen once", ""};
  // A node that lost its address sends from others.
  const auto robbed = std::ranges::find(nodes_, true, &Node::robbed);
  if (robbed != nodes_.end())
    return robbed->teller.tell(Sign::strange_frames, strange_since_, now, amount);
  const auto sender = std::ranges::max_element(nodes_, {}, &Node::follows_strange);
  if (nodes_.size() > 1 && sender->follows_strange * 2 > strange_)
    return sender->teller.tell(Sign::strange_frames, strange_since_, now, amount);
  tell_all(Sign::strange_frames, strange_since_, now, amount);
}

void BusMonitor::tell_all(Sign sign, Stamp since, Stamp now, const Amount& amount) {
  for (const Node& node : nodes_) node.teller.tell(sign, since, now, amount);
}

}  // namespace drydock::diagnosis

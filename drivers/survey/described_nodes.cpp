#include "drivers/survey/described_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace drydock::survey {
namespace {

Node node_of(const DescribedTrial& trial) {
  Node node;
  node.kind = NodeKind::described;
  node.title = trial.description().title;
  for (const auto& [id, arrivals] : trial.match().heard()) {
    node.frames += arrivals.count;
    node.traffic.push_back({id.id, arrivals.count, arrivals.rate_hz()});
  }
  node.sensors.push_back(trial.heard());
  node.confidence = trial.is_certain() ? Confidence::certain : Confidence::likely;
  node.only_described = true;
  return node;
}

/// The identifiers that both have, `201h 202h`; empty: none.
std::string shared_ids(const DescribedMatch& match, const std::map<BusId, Arrivals>& heard) {
  std::string text;
  for (const auto& [id, arrivals] : heard)
    if (match.has(id))
      text += fmt::format(fmt::runtime(id.extended ? "{}{:08X}h" : "{}{:03X}h"),
                          text.empty() ? "" : " ", id.id);
  return text;
}

std::string name_of(const Node& sender) {
  switch (sender.kind) {
    case NodeKind::j1939: return fmt::format("J1939 sender {}", sender.address);
    case NodeKind::canopen: return fmt::format("CANopen node {}", sender.address);
    case NodeKind::plain:
    case NodeKind::described: break;
  }
  return {};
}

std::string proof_of(const Node& sender) {
  if (sender.name) return "which claimed its address";
  if (sender.booted) return "whose boot-up was heard";
  if (sender.state) return "whose heartbeat was heard";
  if (sender.answered) return "which answers by SDO";
  if (sender.emergency) return "whose emergency was heard";
  return sender.kind == NodeKind::j1939 ? "which claimed no address"
                                        : "of which no heartbeat, boot-up or SDO answer was heard";
}

}  // namespace

DescribedNodes::DescribedNodes(const std::vector<const DescribedTrial*>& found) {
  for (const auto* trial : found) {
    entries_.push_back({trial, node_of(*trial)});
    for (const auto* other : found) {
      const auto shared = shared_ids(other->match(), trial->match().heard());
      if (other != trial && !shared.empty())
        entries_.back().node.also.push_back(
            fmt::format("{} describes {} too", other->description().name, shared));
    }
  }
}

void DescribedNodes::compare(const std::map<BusId, Arrivals>& heard, Node& sender, bool stays) {
  for (Entry& entry : entries_) {
    const auto shared = shared_ids(entry.trial->match(), heard);
    if (shared.empty()) continue;
    if (!stays || sender.kind == NodeKind::plain)
      entry.node.also.insert(entry.node.also.end(), sender.also.begin(), sender.also.end());
    if (sender.kind == NodeKind::plain) continue;
    if (!stays) {
      auto& numbers = entry.unproved.at(sender.kind == NodeKind::j1939 ? 0 : 1);
      numbers += fmt::format("{}{}", numbers.empty() ? "" : " ", sender.address);
      continue;
    }
    entry.node.also.push_back(
        fmt::format("{} may be of {} too, {}", shared, name_of(sender), proof_of(sender)));
    sender.also.push_back(fmt::format("{} describes {}", entry.trial->description().name, shared));
  }
  if (sender.kind == NodeKind::plain) sender.also.clear();
}

std::vector<Node> DescribedNodes::nodes() const {
  std::vector<Node> all;
  for (const Entry& entry : entries_) {
    all.push_back(entry.node);
    if (!entry.unproved[0].empty())
      all.back().also.push_back("J1939 would have them of the senders " + entry.unproved[0] +
                                ", none of which claimed an address");
    if (!entry.unproved[1].empty())
      all.back().also.push_back("CANopen would have them of the nodes " + entry.unproved[1] +
                                ", of which no heartbeat, boot-up or SDO answer was heard");
  }
  return all;
}

}  // namespace drydock::survey

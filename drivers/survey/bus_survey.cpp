#include "drivers/survey/bus_survey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "drivers/device/bus/can_error_text.hpp"
#include "drivers/survey/described_nodes.hpp"
#include "drivers/wire/can/can_bits.hpp"

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

}  // namespace

BusSurvey::BusSurvey(const Descriptions& descriptions) {
  for (const auto& one : descriptions) {
    if (!one->frames) continue;
    const bool of_senders =
        std::ranges::all_of(one->frames->frames, &wire::described::FrameLayout::is_j1939);
    if (of_senders) of_senders_.push_back(one);
    named_.push_back(
        {one, of_senders ? nullptr : std::make_unique<DescribedTrial>(one), DescribedMatch(one)});
  }
}

BusListener& BusSurvey::listener_of(const CanFrame& frame) {
  const auto key = sender(frame);
  auto& listener = listeners_[key];
  if (!listener) listener = std::make_unique<BusListener>(key.first, key.second, of_senders_);
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
  for (Named& one : named_) {
    one.match.receive(frame, at);
    if (one.trial) one.trial->receive(frame, at);
  }
  listener_of(frame).receive(frame, at);
}

BusSurvey::Trials BusSurvey::found_on_the_bus() const {
  Trials found;
  for (const Named& one : named_)
    if (one.trial && one.trial->is_found()) found.push_back(one.trial.get());
  return found;
}

bool BusSurvey::is_named(BusId id) const {
  return std::ranges::any_of(named_,
                             [&](const Named& one) { return one.trial && one.match.has(id); });
}

std::vector<Node> BusSurvey::nodes() const {
  const Trials found = found_on_the_bus();
  const auto is_taken = [&](BusId id) {
    return std::ranges::any_of(found, [&](const auto* one) { return one->match().has(id); });
  };
  DescribedNodes described(found);
  std::vector<Node> others;
  for (const auto& [key, listener] : listeners_) {
    Node node = listener->node(is_taken);
    node.only_described = std::ranges::all_of(listener->heard(),
                                              [&](const auto& one) { return is_named(one.first); });
    const bool all_taken = std::ranges::all_of(
        listener->heard(), [&](const auto& one) { return is_taken(one.first); });
    const bool stays = !all_taken || node.has_proof();
    described.compare(listener->heard(), node, stays);
    if (stays) others.push_back(std::move(node));
  }
  std::vector<Node> nodes = described.nodes();
  std::ranges::move(others, std::back_inserter(nodes));
  return nodes;
}

std::vector<std::string> BusSurvey::missed() const {
  const std::vector<Node> all = nodes();
  std::vector<std::string> texts;
  for (const Named& one : named_) {
    const auto is_it = [&](const SensorHeard& heard) {
      return heard.description == one.description;
    };
    if (std::ranges::any_of(
            all, [&](const Node& node) { return std::ranges::any_of(node.sensors, is_it); }))
      continue;
    std::string text =
        fmt::format("{} is not on this bus: {}", one.description->name, one.match.in_words());
    if (one.match.fits())
      text += one.trial && one.trial->driver().measurements() > 0
                  ? ", but its values cannot be true"
                  : ", but no measurement came of them";
    texts.push_back(std::move(text));
  }
  return texts;
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

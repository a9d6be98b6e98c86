#include "drivers/monitor/hints/wire_hints.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/wire/protocols.hpp"

namespace drydock::monitor {
namespace {

constexpr std::uint64_t most_bytes = 65'536, most_frames = 5'000;  // enough to know a protocol

using survey::Confidence;
using survey::NodeKind;

std::string list_of(const std::vector<survey::Node>& nodes, NodeKind kind, std::string_view one,
                    std::string_view several) {
  std::string numbers;
  std::size_t count = 0;
  for (const auto& node : nodes)
    if (node.kind == kind) numbers += fmt::format("{}{}", count++ == 0 ? "" : ", ", node.address);
  return count == 0 ? std::string() : fmt::format("{} {}", count == 1 ? one : several, numbers);
}

std::string heard_nodes(const std::vector<survey::Node>& nodes) {
  std::string all = list_of(nodes, NodeKind::canopen, "CANopen node", "CANopen nodes");
  const auto sources = list_of(nodes, NodeKind::j1939, "N2K source", "N2K sources");
  if (!all.empty() && !sources.empty()) all += "; ";
  return all + sources;
}

std::string types_of(const survey::ByteFinding& finding) {
  std::string all;
  for (const auto& message : finding.messages)
    all += (all.empty() ? "" : ", ") + std::string(message.type);
  for (const auto& unread : finding.unread) all += (all.empty() ? "" : ", ") + unread.name;
  return all;
}

NodeKind kind_of(wire::Network network) {
  return network == wire::Network::canopen ? NodeKind::canopen : NodeKind::j1939;
}

}  // namespace

std::string line_hint(const survey::ByteSurvey& heard, std::string_view protocol) {
  if (heard.bytes() == 0) return {};
  const auto best = heard.best();
  if (best.confidence < Confidence::likely && !heard.text().empty())
    return fmt::format("text without a {} frame: \"{}\"; does it wait for a command?", protocol,
                       heard.text());
  if (best.confidence < Confidence::likely)
    return fmt::format("{} bytes, but no {} frame, nor one of any other protocol: the baud rate?",
                       heard.bytes(), protocol);
  if (best.protocol != protocol)
    return fmt::format("bytes, but no {} frame; they look like {}", protocol, best.protocol);
  return "heard and not used: " + types_of(best);
}

std::string bus_hint(const std::vector<survey::Node>& heard, const device::DriverOptions& wanted) {
  const auto* protocol = wire::find_protocol(wanted.protocol);
  if (protocol == nullptr || protocol->network == wire::Network::none || heard.empty()) return {};
  const NodeKind kind = kind_of(protocol->network);
  const auto own = std::ranges::find_if(heard, [&](const survey::Node& node) {
    return node.kind == kind && (node.address == wanted.address || wanted.address == 0);
  });
  if (own == heard.end())
    return fmt::format("nothing from address {}; heard: {}", wanted.address, heard_nodes(heard));
  if (own->state == wire::canopen::NodeState::pre_operational)
    return fmt::format(
        "node {} is pre-operational: nobody started it; drydock drive does, or monitor --start",
        own->address);
  return {};
}

namespace {

bool one_is_silent(const std::vector<const device::Device*>& devices) {
  return std::ranges::any_of(devices,
                             [](const device::Device* device) { return device->messages() == 0; });
}

}  // namespace

void WireHints::add(const device::Device& device) {
  if (device.on_bus())
    buses_[device.options().link].devices.push_back(&device);
  else
    lines_[device.options().link].devices.push_back(&device);
}

void WireHints::on_bytes(std::string_view link, shell::Direction way, wire::Bytes bytes, Stamp at) {
  const auto line = lines_.find(link);
  if (way != shell::Direction::received || line == lines_.end()) return;
  if (one_is_silent(line->second.devices) && line->second.survey->bytes() < most_bytes)
    line->second.survey->feed(bytes, at);
}

void WireHints::on_frame(std::string_view link, shell::Direction way, const wire::CanFrame& frame,
                         Stamp at) {
  const auto bus = buses_.find(link);
  if (way != shell::Direction::received || bus == buses_.end()) return;
  if (one_is_silent(bus->second.devices) && bus->second.survey->frames() < most_frames)
    bus->second.survey->receive(frame, at);
}

std::string WireHints::hint(const device::Device& device) const {
  const auto& options = device.options();
  if (device.messages() > 0) return {};
  if (const auto bus = buses_.find(options.link); device.on_bus() && bus != buses_.end())
    return bus_hint(bus->second.survey->nodes(), options.driver);
  const auto line = lines_.find(options.link);
  return line == lines_.end() ? std::string()
                              : line_hint(*line->second.survey, options.driver.protocol);
}

}  // namespace drydock::monitor

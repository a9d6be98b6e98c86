#include "drivers/monitor/frames/rig_wires.hpp"

namespace drydock::monitor {

void RigWires::add(const device::Device& device) {
  const auto& options = device.options();
  if (!device.on_bus()) {
    auto& watch = lines_[options.link][options.driver.protocol];
    if (!watch) watch = watch_bytes(options.driver.protocol, options.driver.description);
    return;
  }
  auto& bus = buses_[options.link];
  if (!bus) bus = watch_bus();
  bus->add(options.driver.protocol, options.driver.description);
}

void RigWires::on_bytes(std::string_view link, shell::Direction way, wire::Bytes bytes, Stamp at) {
  const auto line = lines_.find(link);
  if (way != shell::Direction::received || line == lines_.end()) return;
  for (auto& [protocol, watch] : line->second)
    if (watch) watch->receive(bytes, at);
}

void RigWires::on_frame(std::string_view link, shell::Direction, const wire::CanFrame& frame,
                        Stamp at) {
  const auto bus = buses_.find(link);
  if (bus != buses_.end()) bus->second->receive(frame, at);
}

ShownWire RigWires::show(const std::string& link, const std::string& protocol) {
  if (const auto bus = buses_.find(link); bus != buses_.end()) return bus->second->show();
  const auto line = lines_.find(link);
  if (line == lines_.end()) return {};
  const auto watch = line->second.find(protocol);
  return watch != line->second.end() && watch->second ? watch->second->show() : ShownWire{};
}

}  // namespace drydock::monitor

#include "drivers/monitor/frames/rig_wires.hpp"

namespace drydock::monitor {

void RigWires::add(const device::Device& device) {
  const auto& options = device.options();
  if (!device.on_bus()) {
    lines_[options.link] = watch_bytes(options.driver.protocol, options.driver.description);
    return;
  }
  auto& bus = buses_[options.link];
  if (!bus) bus = watch_bus();
  bus->add(options.driver.protocol, options.driver.description);
}

void RigWires::on_bytes(std::string_view link, shell::Direction way, wire::Bytes bytes, Stamp at) {
  const auto line = lines_.find(link);
  if (way == shell::Direction::received && line != lines_.end() && line->second)
    line->second->receive(bytes, at);
}

void RigWires::on_frame(std::string_view link, shell::Direction, const wire::CanFrame& frame,
                        Stamp at) {
  const auto bus = buses_.find(link);
  if (bus != buses_.end()) bus->second->receive(frame, at);
}

ShownWire RigWires::show(const std::string& link) {
  if (const auto bus = buses_.find(link); bus != buses_.end()) return bus->second->show();
  const auto line = lines_.find(link);
  return line != lines_.end() && line->second ? line->second->show() : ShownWire{};
}

}  // namespace drydock::monitor

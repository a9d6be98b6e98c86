#include "drivers/shell/bus_line.hpp"

#include <algorithm>

namespace drydock::shell {

link::Uri BusLine::next_uri() {
  const bool listens = std::ranges::all_of(devices(), &device::Device::listens_only);
  return listens ? link::listening(uri()) : uri();
}

void BusLine::observe_link() {
  for (device::Device* device : devices()) {
    device->note_dropped(current_link().dropped());
    device->note_link(current_link().note());
    if (const auto rate = current_link().bit_rate()) device->set_bitrate(*rate);
  }
}

void BusLine::receive(const wire::CanFrame& frame, Stamp at) {
  const std::uint64_t dropped = current_link().dropped();
  for (device::Device* device : devices()) {
    device->note_dropped(dropped);
    device->receive(frame, at);
  }
}

}  // namespace drydock::shell

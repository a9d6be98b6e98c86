#include "drivers/shell/bus_line.hpp"

namespace drydock::shell {

void BusLine::receive(const wire::CanFrame& frame, Stamp at) {
  const std::uint64_t dropped = current_link().dropped();
  for (device::Device* device : devices()) {
    device->note_dropped(dropped);
    device->receive(frame, at);
  }
}

}  // namespace drydock::shell

#include "hil/replay/rigs/rig_readers.hpp"

#include <stdexcept>

#include "drivers/shell/rig_devices.hpp"

namespace drydock::replay {

std::vector<RigReader> readers_of(const rig_config::Rig& rig, const decode::ReplayOptions& how) {
  std::vector<RigReader> readers;
  for (std::size_t i = 0; i < rig.devices.size(); ++i) {
    const auto device = shell::make_device(rig, i);
    if (!device) throw std::runtime_error(device.error().message);
    auto options = shell::device_options(rig, i);
    if (!options) throw std::runtime_error(options.error().message);
    RigReader reader{rig.devices[i].name, (*device)->on_bus(), how};
    auto& of_driver = reader.how;
    of_driver.protocol = options->driver.protocol;
    of_driver.kind = to_string(options->driver.kind);
    of_driver.description = options->driver.description;
    of_driver.address = options->driver.address;
    if (of_driver.baud == 0) of_driver.baud = options->driver.baud.value_or(0);
    of_driver.driver = std::move(options->driver);
    readers.push_back(std::move(reader));
  }
  return readers;
}

bool understands(const RigReader& reader, const CapturePart& part) {
  return part.frames == reader.on_bus && measurements_of(part, reader.how) > 0;
}

}  // namespace drydock::replay

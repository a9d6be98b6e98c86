#include "drivers/wire/described/description.hpp"
#include "rig_config/rig.hpp"

namespace drydock::rig_config {

const wire::Protocol* protocol_of(const DeviceConfig& device) {
  return device.description ? &device.description->facts : wire::find_protocol(device.protocol);
}

}  // namespace drydock::rig_config

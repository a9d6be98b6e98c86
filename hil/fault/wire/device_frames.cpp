#include "hil/fault/wire/device_frames.hpp"

#include <algorithm>
#include <array>

#include "drivers/wire/can/sbg.hpp"
#include "drivers/wire/described/description.hpp"
#include "drivers/wire/described/frame_plan.hpp"
#include "drivers/wire/protocols.hpp"

namespace drydock::fault {

namespace {

constexpr std::uint32_t source_address = 0xFF;  // SAE J1939-21: the low byte of the identifier
constexpr std::uint32_t node_bits = 0x7F;       // CiA 301: predefined connection set
constexpr unsigned function_shift = 7;

/// Messages that a CANopen node sends: EMCY, the four TPDOs, SDO answers, heartbeat.
constexpr std::array<std::uint32_t, 7> sent_by_node{0x1, 0x3, 0x5, 0x7, 0x9, 0xB, 0xE};

}  // namespace

DeviceFrames::DeviceFrames(const rig_config::DeviceConfig& device)
    : address_(static_cast<std::uint32_t>(device.address)), description_(device.description) {
  if (description_ && description_->frames) {
    scheme_ = Scheme::described;
    return;
  }
  const wire::Protocol* known = rig_config::protocol_of(device);
  const bool one_node = known && !known->kinds.empty();  // not all of a bus, as with `j1939`
  if (one_node && known->network == wire::Network::j1939)
    scheme_ = Scheme::j1939;
  else if (one_node && known->network == wire::Network::canopen)
    scheme_ = Scheme::canopen;
  else if (device.protocol == wire::Xsens::name)
    scheme_ = Scheme::xsens;
  else if (device.protocol == wire::Sbg::name)
    scheme_ = Scheme::sbg;
  xsens_.extended = device.xsens.extended;
  for (const auto& identifier : device.xsens.identifiers)
    xsens_.set(identifier.message, identifier.id);
}

/// On J1939 all frames of its address are the device's, else those that its DBC file names.
bool DeviceFrames::is_described(const wire::CanFrame& frame) const {
  const bool by_address =
      description_->facts.network == wire::Network::j1939 && address_ != 0 && frame.extended;
  return by_address ? (frame.id & source_address) == address_
                    : description_->frames->catalogue.find(frame).has_value();
}

bool DeviceFrames::has(const wire::CanFrame& frame) const {
  if (frame.error) return false;  // the controller makes it, not a device
  const auto is_addressed = [&](std::uint32_t sender) {
    return address_ == 0 ? sender != 0 : sender == address_;
  };
  switch (scheme_) {
    case Scheme::none: return true;
    case Scheme::described: return is_described(frame);
    case Scheme::xsens: return xsens_.message_of(frame).has_value();
    case Scheme::sbg: return wire::sbg::is_ours(frame);
    case Scheme::j1939: return frame.extended && is_addressed(frame.id & source_address);
    case Scheme::canopen:
      return !frame.extended && is_addressed(frame.id & node_bits) &&
             std::ranges::find(sent_by_node, frame.id >> function_shift) != sent_by_node.end();
  }
  return false;
}

}  // namespace drydock::fault

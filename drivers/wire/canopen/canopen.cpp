#include "drivers/wire/canopen/canopen.hpp"

#include <algorithm>

#include "drivers/wire/bytes.hpp"

namespace drydock::wire::canopen {

namespace {

/// CANopen uses 11-bit data frames of classical CAN.
bool is_data(const CanFrame& frame) {
  return !frame.extended && !frame.remote && !frame.error && !frame.fd;
}

CanFrame data_frame(std::uint32_t id, std::uint8_t size) {
  CanFrame frame;
  frame.id = id;
  frame.size = size;
  return frame;
}

}  // namespace

std::string_view to_string(NodeState state) {
  switch (state) {
    case NodeState::boot_up: return "boot_up";
    case NodeState::stopped: return "stopped";
    case NodeState::operational: return "operational";
    case NodeState::pre_operational: return "pre_operational";
  }
  return "unknown";
}

std::optional<std::uint8_t> node_above(const CanFrame& frame, std::uint32_t base) {
  if (!is_data(frame) || frame.id <= base || frame.id > base + 127) return std::nullopt;
  return static_cast<std::uint8_t>(frame.id - base);
}

bool is_sync(const CanFrame& frame) { return is_data(frame) && frame.id == sync_id; }

std::optional<Nmt> decode_nmt(const CanFrame& frame) {
  if (!is_data(frame) || frame.id != nmt_id || frame.size != 2) return std::nullopt;
  switch (const auto command = static_cast<NmtCommand>(frame.data[0])) {
    case NmtCommand::start:
    case NmtCommand::stop:
    case NmtCommand::enter_pre_operational:
    case NmtCommand::reset_node:
    case NmtCommand::reset_communication: return Nmt{command, frame.data[1]};
  }
  return std::nullopt;
}

std::optional<Heartbeat> decode_heartbeat(const CanFrame& frame) {
  const auto node = node_above(frame, heartbeat_base);
  if (!node || frame.size != 1) return std::nullopt;
  constexpr std::uint8_t toggle_bit = 0x80;
  if (frame.data[0] == toggle_bit) return std::nullopt;  // no guarded node is booting
  switch (const auto state = static_cast<NodeState>(frame.data[0] & ~toggle_bit)) {
    case NodeState::boot_up:
    case NodeState::stopped:
    case NodeState::operational:
    case NodeState::pre_operational: return Heartbeat{*node, state};
  }
  return std::nullopt;
}

std::optional<Emergency> decode_emergency(const CanFrame& frame) {
  const auto node = node_above(frame, emergency_base);
  if (!node || frame.size != 8) return std::nullopt;
  Emergency m{*node, load_le<std::uint16_t>(frame.data, 0), frame.data[2], {}};
  std::copy_n(frame.data.begin() + 3, m.vendor.size(), m.vendor.begin());
  return m;
}

CanFrame encode(const Nmt& m) {
  CanFrame frame = data_frame(nmt_id, 2);
  frame.data[0] = static_cast<std::uint8_t>(m.command);
  frame.data[1] = m.node;
  return frame;
}

CanFrame encode(const Heartbeat& m) {
  CanFrame frame = data_frame(heartbeat_base + m.node, 1);
  frame.data[0] = static_cast<std::uint8_t>(m.state);
  return frame;
}

CanFrame encode(const Emergency& m) {
  CanFrame frame = data_frame(emergency_base + m.node, 8);
  store_le<std::uint16_t>(frame.data, 0, m.code);
  frame.data[2] = m.error_register;
  std::copy(m.vendor.begin(), m.vendor.end(), frame.data.begin() + 3);
  return frame;
}

CanFrame sync_frame() { return data_frame(sync_id, 0); }

}  // namespace drydock::wire::canopen

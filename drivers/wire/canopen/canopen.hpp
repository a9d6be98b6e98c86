#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"

/// Services of CANopen (CiA 301) that a sensor needs in addition to its process data: network
/// management, boot-up and heartbeat, emergency, SYNC. Node numbers are 1..127.
namespace drydock::wire::canopen {

constexpr std::uint32_t nmt_id = 0x000;
constexpr std::uint32_t sync_id = 0x080;
constexpr std::uint32_t emergency_base = 0x080;
constexpr std::uint32_t heartbeat_base = 0x700;

/// COB-ID of transmit PDO 1..4 of a node, predefined connection set.
constexpr std::uint32_t tpdo_id(unsigned number, std::uint8_t node) {
  return 0x080 + 0x100 * number + node;
}

enum class NmtCommand : std::uint8_t {
  start = 0x01,
  stop = 0x02,
  enter_pre_operational = 0x80,
  reset_node = 0x81,
  reset_communication = 0x82,
};

struct Nmt {
  static constexpr std::string_view type = "nmt";
  NmtCommand command = NmtCommand::start;
  std::uint8_t node = 0;  ///< 0: all nodes
};

enum class NodeState : std::uint8_t {
  boot_up = 0x00,
  stopped = 0x04,
  operational = 0x05,
  pre_operational = 0x7F,
};

std::string_view to_string(NodeState state);

/// A node's heartbeat. Its first one, with state boot_up, means that the node has started. An
/// answer to node guarding says the same; its toggle bit is left out.
struct Heartbeat {
  static constexpr std::string_view type = "heartbeat";
  std::uint8_t node = 0;
  NodeState state = NodeState::boot_up;
};

/// A node's fault report. Code 0 means that the fault has ended.
struct Emergency {
  static constexpr std::string_view type = "emergency";
  std::uint8_t node = 0;
  std::uint16_t code = 0;
  std::uint8_t error_register = 0;  ///< object 1001h
  std::array<std::uint8_t, 5> vendor{};
};

/// CiA 301's words for an emergency code. If the code has no name of its own, the words are those
/// of its class.
std::string_view error_text(std::uint16_t code);

/// The node of an 11-bit data frame with identifier base + 1 to base + 127. Empty for other frames.
std::optional<std::uint8_t> node_above(const CanFrame& frame, std::uint32_t base);

bool is_sync(const CanFrame& frame);
std::optional<Nmt> decode_nmt(const CanFrame& frame);
std::optional<Heartbeat> decode_heartbeat(const CanFrame& frame);
std::optional<Emergency> decode_emergency(const CanFrame& frame);

CanFrame encode(const Nmt& message);
CanFrame encode(const Heartbeat& message);
CanFrame encode(const Emergency& message);
CanFrame sync_frame();

template <class Field>
void visit_fields(const Heartbeat& m, Field&& field) {
  field("node", m.node);
  field("state", to_string(m.state));
}

template <class Field>
void visit_fields(const Emergency& m, Field&& field) {
  field("node", m.node);
  field("code", m.code);
  field("error", error_text(m.code));
  field("error_register", m.error_register);
}

}  // namespace drydock::wire::canopen

#include "drivers/wire/canopen/cia402_states.hpp"

#include <array>

namespace drydock::wire::cia402 {

namespace {

using enum DriveState;

/// One row for each state: the bits of its status word that count, and their values.
struct StateRow {
  std::string_view name;
  std::uint16_t mask, bits;
};
constexpr std::array<StateRow, 8> rows{{
    {"not_ready_to_switch_on", 0x4F, 0x00},
    {"switch_on_disabled", 0x4F, 0x40},
    {"ready_to_switch_on", 0x6F, 0x21},
    {"switched_on", 0x6F, 0x23},
    {"operation_enabled", 0x6F, 0x27},
    {"quick_stop_active", 0x6F, 0x07},
    {"fault_reaction_active", 0x4F, 0x0F},
    {"fault", 0x4F, 0x08},
}};

constexpr std::uint16_t voltage_enabled = 0x10, remote = 0x200;

const StateRow& row_of(DriveState state) { return rows.at(static_cast<std::size_t>(state)); }

/// A pattern of the control word's lowest bits.
bool asks(std::uint16_t word, std::uint16_t mask, std::uint16_t bits) {
  return (word & (mask | fault_reset)) == bits;
}

}  // namespace

std::string_view to_string(DriveState state) { return row_of(state).name; }

std::optional<DriveState> state_of(std::uint16_t status_word) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if ((status_word & rows[i].mask) == rows[i].bits) return static_cast<DriveState>(i);
  return std::nullopt;
}

std::uint16_t status_word_of(DriveState state) {
  std::uint16_t word = row_of(state).bits | remote;
  const bool powered = state >= ready_to_switch_on && state <= fault_reaction_active;
  return powered ? word | voltage_enabled : word;
}

DriveState after(DriveState state, std::uint16_t word, std::uint16_t word_before) {
  const bool stops_at_once = asks(word, 0x06, 0x02), cuts_off = asks(word, 0x02, 0x00);
  const bool shuts_down = asks(word, 0x07, shutdown);
  switch (state) {
    case not_ready_to_switch_on: break;
    case switch_on_disabled: return shuts_down ? ready_to_switch_on : state;
    case ready_to_switch_on:
      if (stops_at_once || cuts_off) return switch_on_disabled;
      if (asks(word, 0x0F, switch_on)) return switched_on;
      return asks(word, 0x0F, enable_operation) ? operation_enabled : state;
    case switched_on:
      if (stops_at_once || cuts_off) return switch_on_disabled;
      if (shuts_down) return ready_to_switch_on;
      return asks(word, 0x0F, enable_operation) ? operation_enabled : state;
    case operation_enabled:
      if (cuts_off) return switch_on_disabled;
      if (stops_at_once) return quick_stop_active;
      if (shuts_down) return ready_to_switch_on;
      return asks(word, 0x0F, switch_on) ? switched_on : state;
    case quick_stop_active:
      if (cuts_off) return switch_on_disabled;
      return asks(word, 0x0F, enable_operation) ? operation_enabled : state;
    case fault_reaction_active: break;
    case fault:
      if ((word & fault_reset) != 0 && (word_before & fault_reset) == 0) return switch_on_disabled;
  }
  return state;
}

std::uint16_t word_towards_operation(DriveState state) {
  switch (state) {
    case switch_on_disabled: return shutdown;
    case ready_to_switch_on: return switch_on;
    case fault: return fault_reset;
    case switched_on:
    case operation_enabled: return enable_operation;
    case quick_stop_active: return disable_voltage;
    case not_ready_to_switch_on:
    case fault_reaction_active: break;
  }
  return disable_voltage;
}

}  // namespace drydock::wire::cia402

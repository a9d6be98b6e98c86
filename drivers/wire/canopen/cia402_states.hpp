#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

/// The state machine of a drive, CiA 402-2 (IEC 61800-7-201): the control word (object 6040h) asks
/// for transitions, the status word (6041h) tells the state.
namespace drydock::wire::cia402 {

enum class DriveState : std::uint8_t {
  not_ready_to_switch_on,
  switch_on_disabled,
  ready_to_switch_on,
  switched_on,
  operation_enabled,  ///< only here does it follow its target
  quick_stop_active,
  fault_reaction_active,
  fault,
};

std::string_view to_string(DriveState state);

/// Empty: the word tells no state of the profile.
std::optional<DriveState> state_of(std::uint16_t status_word);
/// With the bits "voltage enabled" and "remote" that go with it.
std::uint16_t status_word_of(DriveState state);

/// Bits of the status word that are told in "operation enabled". Bit 11 holds in every mode; bits
/// 10 and 12 have a meaning in each, here those of profile velocity and of cyclic synchronous
/// position.
inline constexpr std::uint16_t target_reached = 1u << 10, internal_limit_active = 1u << 11,
                               speed_is_zero = 1u << 12, follows_target = 1u << 12;

/// The state after a control word. Only the rise of bit 7 resets a fault, so the word before counts
/// too.
DriveState after(DriveState state, std::uint16_t control_word, std::uint16_t word_before);

/// The control word that takes a drive one transition closer to "operation enabled". For a fault it
/// is the reset, which the drive takes only after a word without it.
std::uint16_t word_towards_operation(DriveState state);

inline constexpr std::uint16_t shutdown = 0x06, switch_on = 0x07, enable_operation = 0x0F,
                               quick_stop = 0x02, disable_voltage = 0x00, fault_reset = 0x80;

}  // namespace drydock::wire::cia402

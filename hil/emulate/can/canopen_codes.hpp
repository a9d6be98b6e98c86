#pragma once

#include <cstdint>

/// Objects of the communication of every node (CiA 301, 7.5.2).
namespace drydock::emulate::cia301 {

constexpr std::uint16_t device_type = 0x1000, error_register = 0x1001, errors = 0x1003,
                        sync_id = 0x1005, name = 0x1008, hardware = 0x1009, software = 0x100A,
                        guard_time = 0x100C, life_factor = 0x100D, store = 0x1010, restore = 0x1011,
                        emergency_id = 0x1014, consumer_heartbeat = 0x1016, heartbeat = 0x1017,
                        identity = 0x1018, error_behaviour = 0x1029, first_of_maker = 0x2000;

}  // namespace drydock::emulate::cia301

/// Abort codes of SDO transfers, and the emergency codes that every node sends (CiA 301, tables 22
/// and 26).
namespace drydock::emulate::sdo {

constexpr std::uint32_t taken = 0;  ///< no abort

constexpr std::uint32_t toggle_wrong = 0x05030000, unknown_command = 0x05040001,
                        read_only = 0x06010002, no_such_object = 0x06020000,
                        cannot_be_mapped = 0x06040041, pdo_too_long = 0x06040042,
                        wrong_length = 0x06070010, too_long = 0x06070012,
                        no_such_subindex = 0x06090011, beyond_range = 0x06090030,
                        wrong_signature = 0x08000020, not_in_this_state = 0x08000022,
                        no_data = 0x08000024;

constexpr std::uint16_t master_lost = 0x8130, pdo_too_short = 0x8210;
constexpr std::uint8_t communication_error = 0x11;  ///< of the error register, 1001h

}  // namespace drydock::emulate::sdo

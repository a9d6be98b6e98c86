#pragma once

#include <cstdint>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/dvl/pd0_ensemble.hpp"

/// The data types of an ensemble. Their lengths differ between instruments and firmware, so each
/// function reads the fields that are there. False if the block is too short for the main fields.
namespace drydock::wire {

namespace pd0 {
constexpr std::uint16_t fixed_leader = 0x0000, variable_leader = 0x0080, bottom_track = 0x0600;
constexpr std::uint16_t navigation = 0x2013, high_resolution = 0x5803, bottom_range = 0x5804;
constexpr std::int16_t bad = -32768;               ///< for velocities, and for missing sensors
constexpr std::uint8_t has_depth_sensor = 1 << 5;  ///< bit of Pd0FixedLeader::sensors_available
/// Low three bits of the system configuration.
constexpr std::array<double, 7> frequency_hz{75e3, 150e3, 300e3, 600e3, 1200e3, 2400e3, 38e3};
/// Low two bits of the high byte.
constexpr std::array<double, 3> beam_angle_deg{15, 20, 30};
}  // namespace pd0

bool read_block(Bytes block, Pd0FixedLeader& m);
bool read_block(Bytes block, Pd0VariableLeader& m);
bool read_block(Bytes block, Pd0BottomTrack& m);
bool read_block(Bytes block, Pd0HighResolution& m);
bool read_block(Bytes block, Pd0BottomRange& m);
bool read_block(Bytes block, Pd0Navigation& m);

}  // namespace drydock::wire

#pragma once

#include <cstdint>

/// Where the fields of records 1B and 1D stand in their data, and the marks of missing values.
namespace drydock::wire::ad2cp {

inline constexpr std::uint8_t bottom_track_id = 0x1B, water_track_id = 0x1D;

/// The common front, from the first byte of the data.
inline constexpr std::size_t serial_at = 2, clock_at = 6, beam_count_at = 14, error_at = 16,
                             status_at = 20, sound_speed_at = 24, celsius_at = 28, bar_at = 32,
                             front_size = 36;

/// Groups of four numbers, from the offset that the second byte tells.
inline constexpr std::size_t distance_at = 16, groups_size = 176;

struct EstimatesAt {
  std::size_t velocity, merit, after_trigger, after_output, duration;
  unsigned velocity_bit, merit_bit;  ///< of the first of four in the status
};
inline constexpr EstimatesAt beams_at{0, 32, 48, 64, 80, 0, 8},
    axes_at{96, 112, 128, 144, 160, 12, 16};
inline constexpr unsigned distance_bit = 4, all_valid_bits = 20;

inline constexpr float bad_velocity_mps = -32.768F, bad_distance_m = 0, bad_merit_mps = 10;
inline constexpr double pa_per_bar = 1e5;

}  // namespace drydock::wire::ad2cp

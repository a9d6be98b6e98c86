#pragma once

#include <array>
#include <optional>

#include "estimators/roll/antenna.hpp"
#include "estimators/roll/epoch.hpp"
#include "estimators/roll/satellite_slots.hpp"

namespace drydock::roll {

struct PeakOptions {
  /// Largest length of the moving average, epochs. The length is odd, about a third of a turn, and
  /// at least 3.
  int longest_average = 13;
  /// Least height of a peak above the lowest average of its half turn, relative to boresight.
  double least_height = 0.1;
};

/// The measurement of the paper: at the strongest signal of a satellite, eq. (17) gives the roll.
struct Peak {
  std::uint16_t satellite = 0;
  double time_s = 0;    ///< time of the peak
  double gyro_rad = 0;  ///< integral of the gyro at that time
  double roll_rad = 0;  ///< eq. (17), (-pi, pi]
};

/// Finds the peaks of the power of one satellite. A moving average reduces the noise. A peak is an
/// average that no other average within a quarter turn exceeds. The delay is compensated: the time
/// of a peak is the middle of its average, refined to a fraction of an epoch by the parabola
/// through the peak and its neighbours.
class PeakFinder {
 public:
  /// Adds one epoch of the satellite. Times and gyro angles may start at any value.
  std::optional<Peak> add(const PeakOptions& options, double power, double time_s, double gyro_rad,
                          double strongest_roll_rad);
  void clear() { count_ = 0; }

 private:
  struct Sample {
    double power = 0, average = 0;
    double time_s = 0, gyro_rad = 0, strongest_roll_rad = 0;
  };
  static constexpr std::size_t capacity = 64;

  Sample& sample(std::size_t i) { return samples_[i % capacity]; }
  const Sample& sample(std::size_t i) const { return samples_[i % capacity]; }
  double epochs_per_turn() const;
  bool is_peak(std::size_t middle, std::size_t reach, double least_height) const;
  Peak dated(std::size_t middle) const;

  std::array<Sample, capacity> samples_{};
  std::size_t count_ = 0;  ///< sample i is stored at i % capacity
};

}  // namespace drydock::roll

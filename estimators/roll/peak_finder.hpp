#pragma once

#include <array>
#include <optional>

#include "estimators/roll/antenna.hpp"
#include "estimators/roll/epoch.hpp"
#include "estimators/roll/satellite_slots.hpp"

namespace drydock::roll {

struct PeakOptions {
  /// Epochs of the moving average: about a third of a turn, odd, from 3 to this.
  int longest_average = 13;
  /// A peak stands so far above the lowest average of its half turn, as a share of boresight.
  double least_height = 0.1;
};

/// The paper's measurement: a satellite's signal was strongest, so the roll was that of eq. (17).
struct Peak {
  std::uint16_t satellite = 0;
  double time_s = 0;    ///< when it was
  double gyro_rad = 0;  ///< what the gyro had counted by then
  double roll_rad = 0;  ///< eq. (17), (-pi, pi]
};

/// Finds the peaks of one satellite's power: a moving average against the noise, and of the
/// averages one that none within a quarter turn surpasses. The delay of both is compensated: a peak
/// is dated by the middle of its average, and to a fraction of an epoch by the parabola through it
/// and its neighbours.
class PeakFinder {
 public:
  /// One more epoch of the satellite. Times and gyro angles count on from any beginning.
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
  std::size_t count_ = 0;  ///< sample i stands at i % capacity
};

}  // namespace drydock::roll

#pragma once

#include <optional>
#include <string_view>

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"

namespace drydock::device {

/// The water at the head, as the DVL tells it.
struct WaterAtHead {
  std::optional<double> temperature_k, depth_m, salinity_ppt = {};
  std::optional<double> set_mps =
      {};  ///< speed of sound that it has, read back: the rig's is older
};

/// Corrects what a DVL measured with a wrong speed of sound. Doppler shift and travel time give
/// velocities and ranges in proportion to it: true = sent c / c_set. This holds for heads of four
/// pistons; a phased array's horizontal velocity does not depend on the speed of sound.
class SoundSpeedCorrection {
 public:
  explicit SoundSpeedCorrection(const SoundSpeedOptions& options) : options_(options) {}

  /// Scales velocity with its accuracy, error velocity, ranges and altitude, and puts the speed
  /// that they now have into the sample. It leaves the sample as sent, and reports why, if a value
  /// is missing.
  void apply(measurement::BottomVelocity& sample, const WaterAtHead& water, Output& out);

 private:
  std::optional<double> true_speed(const WaterAtHead& water) const;

  SoundSpeedOptions options_;
  std::string_view missing_;
};

}  // namespace drydock::device

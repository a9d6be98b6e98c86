#pragma once

#include <cstddef>
#include <optional>

#include "drivers/measurement/measurement.hpp"
#include "drivers/measurement/sound_speed.hpp"

namespace drydock::measurement {

/// The speed of sound that a DVL used, beside that of the water at its head as it tells it. Its
/// velocities and ranges err by the same share.
class SoundSpeedUsed {
 public:
  struct Means {
    double used_mps = 0, of_water_mps = 0;
    double temperature_k = 0, salinity_ppt = 0, depth_m = 0;
    SoundSpeedEquation equation{};
    std::size_t samples = 0;

    /// Of velocities and ranges; positive: they are too large.
    double error() const { return used_mps / of_water_mps - 1; }
  };

  /// Samples without the speed or the temperature tell nothing.
  void add(const BottomVelocity& sample) {
    if (!sample.sound_speed_mps || !sample.water_temperature_k) return;
    ++sums_.samples;
    sums_.used_mps += *sample.sound_speed_mps;
    sums_.temperature_k += *sample.water_temperature_k;
    sums_.salinity_ppt += sample.salinity_ppt.value_or(usual_salinity_ppt);
    sums_.depth_m += sample.depth_m.value_or(0);
  }

  std::optional<Means> means() const {
    if (sums_.samples == 0) return {};
    Means means = sums_;
    for (double* sum : {&means.used_mps, &means.temperature_k, &means.salinity_ppt, &means.depth_m})
      *sum /= static_cast<double>(means.samples);
    const double celsius = means.temperature_k - melting_point_k;
    // Mackenzie's equation holds for sea water alone.
    const bool is_sea = means.salinity_ppt >= 25 && celsius >= 2 && celsius <= 30;
    means.equation = is_sea ? SoundSpeedEquation::mackenzie : SoundSpeedEquation::medwin;
    means.of_water_mps =
        sound_speed_mps(means.equation, celsius, means.salinity_ppt, means.depth_m);
    return means;
  }

 private:
  Means sums_;
};

}  // namespace drydock::measurement

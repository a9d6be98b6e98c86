#pragma once

#include "drivers/device/dvl/dvl_gate.hpp"
#include "drivers/device/dvl/sound_speed.hpp"
#include "drivers/device/dvl/velocity_accuracy.hpp"

namespace drydock::device {

/// What every DVL driver does last: the speed of sound put right, the impossible dropped, and the
/// rig's accuracy added where the DVL tells none.
class DvlFinish {
 public:
  explicit DvlFinish(const DriverOptions& options)
      : sound_speed_(options.dvl.sound_speed), sigma_mps_(options.velocity_sigma_mps) {}

  void publish(measurement::BottomVelocity& sample, const WaterAtHead& water, Output& out) {
    sound_speed_.apply(sample, water, out);
    drop_impossible(sample, out);
    add_sigma_of_rig(sample, sigma_mps_);
    sample.depth_m = water.depth_m;
    sample.water_temperature_k = water.temperature_k;
    sample.salinity_ppt = water.salinity_ppt;
    out.publish(sample);
  }

 private:
  SoundSpeedCorrection sound_speed_;
  std::optional<double> sigma_mps_;
};

}  // namespace drydock::device

#include "drivers/device/dvl/sound_speed.hpp"

namespace drydock::device {
namespace {

void scale(std::optional<double>& value, double by) {
  if (value) *value *= by;
}

}  // namespace

void SoundSpeedCorrection::apply(measurement::BottomVelocity& sample, const WaterAtHead& water,
                                 Output& out) {
  if (options_.source == SoundSpeedOptions::Source::as_sent) return;
  const auto of_rig = options_.set_mps ? options_.set_mps : sample.sound_speed_mps;
  const auto set = water.set_mps ? water.set_mps : of_rig;
  const auto speed = true_speed(water);
  const std::string_view missing =
      !set     ? "velocity not corrected: the DVL does not tell the speed of sound that it used"
      : !speed ? "velocity not corrected: the DVL tells no temperature for the speed of sound"
               : "";
  if (missing != missing_ && !missing.empty()) out.report(missing);
  missing_ = missing;
  if (!missing.empty()) return;
  const double by = *speed / *set;
  if (sample.velocity) *sample.velocity *= by;
  scale(sample.error_velocity_mps, by);
  scale(sample.altitude_m, by);
  for (auto& range : sample.range_m) scale(range, by);
  scale(sample.figure_of_merit_mps, by);
  if (sample.velocity_covariance) *sample.velocity_covariance *= by * by;
  sample.sound_speed_mps = *speed;
}

std::optional<double> SoundSpeedCorrection::true_speed(const WaterAtHead& water) const {
  if (options_.source == SoundSpeedOptions::Source::fixed) return options_.fixed_mps;
  const auto temperature_k = options_.temperature_k ? options_.temperature_k : water.temperature_k;
  if (!temperature_k) return {};
  const double depth_m = options_.depth_m ? *options_.depth_m : water.depth_m.value_or(0);
  const auto salinity_ppt = options_.salinity_ppt ? options_.salinity_ppt : water.salinity_ppt;
  return measurement::sound_speed_mps(
      options_.equation, *temperature_k - measurement::melting_point_k,
      salinity_ppt.value_or(measurement::usual_salinity_ppt), depth_m);
}

}  // namespace drydock::device

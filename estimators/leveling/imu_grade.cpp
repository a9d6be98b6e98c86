#include "estimators/leveling/imu_grade.hpp"

#include <algorithm>

namespace drydock::leveling {

LevelingOptions worsened(LevelingOptions options, FilterKind kind, const ImuGrade& imu) {
  const double times = std::max(1.0, imu.gyro_bias_radps / options.gyro_bias_sigma_radps);
  // Without bias states the noise of alpha covers the bias of a gyro.
  if (kind == FilterKind::robust) options.alpha_noise *= times;
  options.gyro_bias_sigma_radps *= times;
  const auto at_least = [](double& figure, double known) { figure = std::max(figure, known); };
  at_least(options.accelerometer_bias_sigma_mps2, imu.accelerometer_bias_mps2);
  at_least(options.alpha_noise, imu.angle_noise_rad);
  at_least(options.velocity_noise, imu.velocity_noise_mps);
  options.gyro_bias_walk_radps = imu.gyro_bias_walk_radps;
  options.accelerometer_bias_walk_mps2 = imu.accelerometer_bias_walk_mps2;
  options.rate_share = imu.rate_share;
  return options;
}

}  // namespace drydock::leveling

#include "hil/study/leveling/leveling_covariance.hpp"

#include "estimators/leveling/leveling_filter.hpp"
#include "hil/study/leveling/leveling_trial.hpp"

namespace drydock::study {

LevelingCovariance analyse_leveling(const LevelingMotion& motion, bool stationary) {
  constexpr double step = 1 / leveling_rate_hz;
  constexpr auto steps = static_cast<std::size_t>(leveling_duration_s * leveling_rate_hz);
  auto options = leveling::options_for(leveling::FilterKind::paper);
  const auto attitude = motion.attitude(0);
  options.latitude_rad = leveling_latitude_rad;
  options.heading_rad = attitude.yaw;
  options.initial_roll_rad = attitude.roll;
  options.initial_pitch_rad = attitude.pitch;
  leveling::LevelingFilter filter(options);
  filter.start({}, {}, motion.velocity(0).x());

  LevelingCovariance analysis;
  const auto note = [&](std::size_t i) {
    analysis.t_s.push_back(static_cast<double>(i) * step);
    for (int k = 0; k < 3; ++k)
      analysis.variance[static_cast<std::size_t>(k)].push_back(filter.covariance()(3 + k, 3 + k));
  };
  note(0);
  for (std::size_t i = 0; i < steps; ++i) {
    const auto perfect = motion.reading(static_cast<double>(i) * step, step, leveling_latitude_rad);
    filter.predict(perfect.specific_force, perfect.angular_rate, step);
    if (stationary)
      filter.update_stationary();
    else
      filter.update_moving(perfect.speed_mps);
    note(i + 1);
  }
  return analysis;
}

}  // namespace drydock::study

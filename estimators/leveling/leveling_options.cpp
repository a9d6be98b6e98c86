#include "estimators/leveling/leveling_options.hpp"

#include <limits>

namespace drydock::leveling {

LevelingOptions options_for(FilterKind kind) {
  LevelingOptions options;
  if (kind == FilterKind::robust) return options;
  // The noise of these filters does not cover biases: the paper's filter ignores them, the
  // augmented filter estimates them.
  options.velocity_noise = 1e-3;
  options.alpha_noise = 1e-6;
  if (kind == FilterKind::paper) {
    options.accelerometer_start = false;
    options.speed_gate = std::numeric_limits<double>::infinity();
    options.vertical_speed_density.reset();
    options.transverse_speed_density.reset();
  }
  return options;
}

}  // namespace drydock::leveling

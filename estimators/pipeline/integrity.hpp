#pragma once

#include <Eigen/Core>
#include <optional>

namespace drydock::pipeline {

/// k of eq. (I1) of docs/estimators/integrity.md: a normal error exceeds k sigmas, on either side,
/// with a probability of 1e-7.
inline constexpr double bound_sigmas = 5.3267;

/// What an estimate promises. An error exceeds a bound with a probability of 1e-7 while the
/// estimate is valid and its sensors are sound.
struct Integrity {
  bool valid = true;
  double roll_bound_rad = 0, pitch_bound_rad = 0;
  std::optional<double> heading_bound_rad, horizontal_bound_m;  ///< empty if not estimated
};

/// Eq. (I1): k sigma + bias. `variance` and the result have the unit of the quantity.
double bound_of(double variance, double bias = 0);

/// An estimate beyond these bounds says too little to be used, so it is not valid. Chosen: the
/// small angles of the filters hold, and the speed over ground of an underwater vehicle is known at
/// all.
struct AlertLimits {
  double attitude_rad = 0.35, velocity_mps = 5;
};

}  // namespace drydock::pipeline

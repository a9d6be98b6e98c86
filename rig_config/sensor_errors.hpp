#pragma once

#include <array>

/// How a sensor errs, as its data sheet or a paper's table says: values of a sensor file in SI.
/// docs/sensors/errors.md numbers the equations; hil/sensor/errors.hpp applies them.
namespace drydock::rig_config {

/// One figure per axis; of a scalar quantity the first alone counts.
using Axes = std::array<double, 3>;

/// q is the unit of the measured quantity. All are one standard deviation. The constants are as
/// given or drawn once per run, as `fixed_bias` says; the rest differs from sample to sample.
struct SensorErrors {
  Axes bias{};          ///< q
  Axes scale_factor{};  ///< 1
  Axes asymmetry{};     ///< 1: scale factor of positive less that of negative input
  Axes nonlinearity{};  ///< 1/q: of the input squared
  Axes misalignment{};  ///< rad: of an input axis toward each of the other two
  /// Of an IMU alone. Gyro: rad/s per m/s2 of specific force (mass unbalance). Accelerometer: m/s2
  /// per rad/s of angular rate.
  Axes sensitivity{};
  Axes anisoelasticity{};  ///< q per (m/s2)^2: of the specific force along two axes

  Axes noise{};                 ///< q: white, per sample
  Axes noise_density{};         ///< q/sqrt(Hz): white; a gyro's angle random walk
  Axes bias_instability{};      ///< q: Gauss-Markov of first order
  double correlation_s = 1000;  ///< its correlation time
  Axes random_walk{};           ///< q/sqrt(s): of the reading; a gyro's rate random walk

  Axes range{};                       ///< q: saturation; 0: none
  Axes quantisation{};                ///< q: step; 0: none
  bool quantisation_carried = false;  ///< the rounded-off rest is added to the next sample
};

}  // namespace drydock::rig_config

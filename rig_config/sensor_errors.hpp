#pragma once

#include <array>

/// Errors of a sensor from its data sheet or from a table of a paper: values of a sensor file in
/// SI. docs/sensors/errors.md has the equations with their numbers; hil/sensor/errors.hpp applies
/// them.
namespace drydock::rig_config {

/// One figure per axis. A scalar quantity uses only the first.
using Axes = std::array<double, 3>;

/// q is the unit of the measured quantity. All values are one standard deviation. The constant
/// errors are either the given values or drawn once per run: `fixed_bias` decides. The other errors
/// change from sample to sample.
struct SensorErrors {
  Axes bias{};          ///< q
  Axes scale_factor{};  ///< 1
  Axes asymmetry{};     ///< 1: scale factor of positive input minus that of negative input
  Axes nonlinearity{};  ///< 1/q: factor of the squared input
  Axes misalignment{};  ///< rad: of an input axis toward each of the other two
  /// IMU only. Gyro: rad/s per m/s2 of specific force (mass unbalance). Accelerometer: m/s2 per
  /// rad/s of angular rate.
  Axes sensitivity{};
  Axes anisoelasticity{};  ///< q per (m/s2)^2: factor of the specific forces along two axes

  Axes noise{};                 ///< q: white, per sample
  Axes noise_density{};         ///< q/sqrt(Hz): white; for a gyro the angle random walk
  Axes bias_instability{};      ///< q: Gauss-Markov of first order
  double correlation_s = 1000;  ///< correlation time of the bias instability
  Axes random_walk{};           ///< q/sqrt(s): of the reading; for a gyro the rate random walk

  Axes range{};                       ///< q: saturation; 0: none
  Axes quantisation{};                ///< q: step; 0: none
  bool quantisation_carried = false;  ///< the rounding error is added to the next sample
};

}  // namespace drydock::rig_config

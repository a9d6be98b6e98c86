#pragma once

#include <Eigen/Core>
#include <numbers>

#include "estimators/roll/antenna.hpp"
#include "estimators/roll/epoch.hpp"

namespace drydock::roll {

/// One standard deviation everywhere.
struct AllSatellitesOptions {
  AntennaOptions antenna;
  double gyro_noise = 0.01 * std::numbers::pi / 180;  ///< rad per sqrt(s)
  double bias_noise = 1e-4 * std::numbers::pi / 180;  ///< rad/s per sqrt(s)
  double bias_sigma_radps = std::numbers::pi / 180;   ///< at the start
  double gain_sigma = 0.3;             ///< of what all signals have in common, about 1
  double satellite_gain_sigma = 0.12;  ///< of each satellite about that
  double gate = 5;                     ///< a signal further off, in its sigmas, is not used
  int hypotheses = 24;                 ///< equally spaced starts over the whole turn, 1 to 24
};

/// One extended Kalman filter: x = [roll, gyro bias, common gain, gain of each satellite], eq.
/// (27). Roll counts on over full turns.
class Hypothesis {
 public:
  static constexpr int size = 3 + static_cast<int>(most_satellites);
  using State = Eigen::Matrix<double, size, 1>;
  using Covariance = Eigen::Matrix<double, size, size>;

  Hypothesis() = default;
  Hypothesis(double roll_rad, double sigma_rad, const AllSatellitesOptions& options);

  /// Eq. (28): `rate` is the roll gyro's, constant over dt.
  void predict(const AllSatellitesOptions& options, double rate_radps, double dt);

  /// Eq. (29) to (32) with one signal, whose gain is number `slot`. False: outside the gate.
  bool update(const AllSatellitesOptions& options, const Signal& signal, const SightLine& line,
              const Epoch& epoch, std::size_t slot);

  /// Another satellite takes the place of number `slot`.
  void forget_gain(std::size_t slot, double sigma);

  const State& state() const { return x_; }
  const Covariance& covariance() const { return p_; }

  double log_likelihood = 0;  ///< of all signals so far; only differences mean something

 private:
  void shift(const State& gain, double by, double shrink);

  State x_ = State::Zero();
  Covariance p_ = Covariance::Zero();
};

}  // namespace drydock::roll

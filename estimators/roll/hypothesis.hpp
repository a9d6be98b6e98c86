#pragma once

#include <Eigen/Core>
#include <numbers>

#include "drivers/measurement/units.hpp"
#include "estimators/roll/antenna.hpp"
#include "estimators/roll/epoch.hpp"
#include "estimators/roll/roll_watch.hpp"

namespace drydock::roll {

/// All sigmas are one standard deviation.
struct AllSatellitesOptions {
  AntennaOptions antenna;
  double gyro_noise = 0.01 * units::degree;           ///< rad per sqrt(s)
  double bias_noise = 1e-4 * std::numbers::pi / 180;  ///< rad/s per sqrt(s)
  double bias_sigma_radps = units::degree;            ///< at the start
  double gain_sigma = 0.3;             ///< of the common gain of all signals, about 1
  double satellite_gain_sigma = 0.12;  ///< of the gain of each satellite, about the common gain
  double gate = 5;                     ///< a signal off by more sigmas is not used
  int hypotheses = 24;                 ///< equally spaced starts over the whole turn, 1 to 24
};

/// One extended Kalman filter: x = [roll, gyro bias, common gain, gain of each satellite], eq.
/// (27). Roll is not wrapped after a full turn.
class Hypothesis {
 public:
  static constexpr int size = 3 + static_cast<int>(most_satellites);
  using State = Eigen::Matrix<double, size, 1>;
  using Covariance = Eigen::Matrix<double, size, size>;

  Hypothesis() = default;
  Hypothesis(double roll_rad, double sigma_rad, const AllSatellitesOptions& options);

  /// Eq. (28): `rate_radps` is the rate of the roll gyro, constant over dt.
  void predict(const AllSatellitesOptions& options, double rate_radps, double dt);

  /// Eq. (29) to (32) with one signal; its gain has the number `slot`. False: outside the gate.
  bool update(const AllSatellitesOptions& options, const Signal& signal, const SightLine& line,
              const Epoch& epoch, std::size_t slot);

  /// The roll and the gyro's bias are less certain than they were: one sigma more of each.
  void loosen(double roll_sigma_rad, double bias_sigma_radps);

  /// Resets the gain number `slot` for another satellite.
  void forget_gain(std::size_t slot, double sigma);

  const State& state() const { return x_; }
  const Covariance& covariance() const { return p_; }

  double log_likelihood = 0;  ///< of all signals so far; only differences have a meaning
  Evidence evidence;          ///< of the signals since it was last reset

 private:
  void shift(const State& gain, double by, double shrink);

  State x_ = State::Zero();
  Covariance p_ = Covariance::Zero();
};

}  // namespace drydock::roll

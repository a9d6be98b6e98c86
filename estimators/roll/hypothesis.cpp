#include "estimators/roll/hypothesis.hpp"

#include <cmath>

#include "estimators/roll/received_power.hpp"

namespace drydock::roll {
namespace {

enum Index : int { i_roll, i_bias, i_common, i_gain };

}  // namespace

Hypothesis::Hypothesis(double roll_rad, double sigma_rad, const AllSatellitesOptions& options) {
  x_.setOnes();
  x_(i_roll) = roll_rad;
  x_(i_bias) = 0;
  p_.diagonal().setConstant(options.satellite_gain_sigma * options.satellite_gain_sigma);
  p_(i_roll, i_roll) = sigma_rad * sigma_rad;
  p_(i_bias, i_bias) = options.bias_sigma_radps * options.bias_sigma_radps;
  p_(i_common, i_common) = options.gain_sigma * options.gain_sigma;
}

void Hypothesis::predict(const AllSatellitesOptions& options, double rate_radps, double dt) {
  x_(i_roll) += (rate_radps - x_(i_bias)) * dt;
  p_.row(i_roll) -= dt * p_.row(i_bias);
  p_.col(i_roll) -= dt * p_.col(i_bias);
  p_(i_roll, i_roll) += options.gyro_noise * options.gyro_noise * dt;
  p_(i_bias, i_bias) += options.bias_noise * options.bias_noise * dt;
}

bool Hypothesis::update(const AllSatellitesOptions& options, const Signal& signal,
                        const SightLine& line, const Epoch& epoch, std::size_t slot) {
  const int own = i_gain + static_cast<int>(slot);
  const double then = x_(i_roll) - epoch.turned_rad + x_(i_bias) * epoch.age_s;
  const Power power = power_of(options.antenna, line, then);
  const double gain = x_(i_common) * x_(own);
  const double expected = gain * power.value;  // eq. (29)

  const double by_roll = gain * power.slope, by_bias = by_roll * epoch.age_s;
  const double by_common = x_(own) * power.value, by_own = x_(i_common) * power.value;
  const State ph = by_roll * p_.col(i_roll) + by_bias * p_.col(i_bias) +
                   by_common * p_.col(i_common) + by_own * p_.col(own);
  const double variance = by_roll * ph(i_roll) + by_bias * ph(i_bias) + by_common * ph(i_common) +
                          by_own * ph(own) + options.antenna.noise * options.antenna.noise;
  const double sigma = std::sqrt(variance);

  const auto seen = interval_of(options.antenna, signal);
  if (!seen) return true;
  const Interval z{(seen->low - expected) / sigma, (seen->high - expected) / sigma};
  const double leverage = by_roll / sigma;  // of the roll on this signal, in sigmas
  if (z.low > options.gate || z.high < -options.gate) {
    log_likelihood -= 0.5 * options.gate * options.gate;
    const double beyond = z.low > options.gate ? options.gate : -options.gate;
    evidence.score += leverage * beyond;
    evidence.information += leverage * leverage;
    return false;
  }
  const Moments moments = within(z);
  evidence.score += leverage * moments.shift;
  evidence.information += leverage * leverage * moments.shrink;
  log_likelihood += moments.log_probability - (z.low == z.high ? std::log(sigma) : 0);  // eq. (33)
  shift(ph, moments.shift / sigma, moments.shrink / variance);
  return true;
}

void Hypothesis::shift(const State& ph, double by, double shrink) {
  x_ += ph * by;
  p_.noalias() -= ph * (ph * shrink).transpose();
}

void Hypothesis::loosen(double roll_sigma_rad, double bias_sigma_radps) {
  p_(i_roll, i_roll) += roll_sigma_rad * roll_sigma_rad;
  p_(i_bias, i_bias) += bias_sigma_radps * bias_sigma_radps;
}

void Hypothesis::forget_gain(std::size_t slot, double sigma) {
  const int own = i_gain + static_cast<int>(slot);
  x_(own) = 1;
  p_.row(own).setZero();
  p_.col(own).setZero();
  p_(own, own) = sigma * sigma;
}

}  // namespace drydock::roll

#include "hil/study/roll/roll_witness.hpp"

#include <cmath>
#include <numbers>

#include "estimators/roll/received_power.hpp"

namespace drydock::study {
namespace {

constexpr double turn_variance = std::numbers::pi * std::numbers::pi / 3;  // any roll

double squared(double x) { return x * x; }

}  // namespace

RollWitness::RollWitness(const RollCase& the_case, const RollFlight& flight,
                         const roll::AllSatellitesOptions& options, double bias_radps)
    : flight_(&flight), options_(options) {
  const auto& sky = flight.sky().toward_ned;
  const auto satellites = static_cast<Eigen::Index>(sky.size());
  p_ = Eigen::MatrixXd::Zero(3 + satellites, 3 + satellites);
  p_(0, 0) = turn_variance;
  p_(1, 1) = squared(options.bias_sigma_radps);
  p_(2, 2) = squared(the_case.gain_sigma);
  p_.diagonal().tail(satellites).setConstant(squared(the_case.satellite_gain_sigma));

  // It begins at the means of the priors: no bias, all gains 1. Gains without variation are known.
  error_ = Eigen::VectorXd::Zero(3 + satellites);
  error_(1) = -bias_radps;
  double mean = 0;
  for (std::size_t i = 0; i < sky.size(); ++i)
    mean += flight.gain(i) / static_cast<double>(satellites);
  if (the_case.gain_sigma > 0) error_(2) = 1 - mean;
  if (the_case.satellite_gain_sigma > 0)
    for (Eigen::Index i = 0; i < satellites; ++i)
      error_(3 + i) = mean - flight.gain(static_cast<std::size_t>(i));
}

void RollWitness::predict(double rate_noise_radps, double dt) {
  error_(0) += (rate_noise_radps - error_(1)) * dt;
  p_.row(0) -= dt * p_.row(1);  // (34)
  p_.col(0) -= dt * p_.col(1);
  p_(0, 0) += squared(options_.gyro_noise) * dt;
  p_(1, 1) += squared(options_.bias_noise) * dt;
}

void RollWitness::update(double t, std::span<const roll::Signal> signals) {
  for (std::size_t i = 0; i < signals.size(); ++i) {
    const roll::SightLine line(flight_->sky().toward_ned[i], flight_->path(t),
                               options_.antenna.boresight_body);
    const auto power = roll::power_of(options_.antenna, line, flight_->true_roll(t));
    Eigen::VectorXd h = Eigen::VectorXd::Zero(error_.size());
    h(0) = flight_->gain(i) * power.slope;
    h(2) = h(3 + static_cast<Eigen::Index>(i)) = power.value;

    const Eigen::VectorXd ph = p_ * h;
    const double sigma = std::sqrt(h.dot(ph) + squared(options_.antenna.noise));
    const double expected = flight_->gain(i) * power.value + h.dot(error_);
    const auto seen = roll::interval_of(options_.antenna, signals[i]);
    if (!seen) continue;
    const roll::Interval z{(seen->low - expected) / sigma, (seen->high - expected) / sigma};
    if (z.low > options_.gate || z.high < -options_.gate) continue;
    const auto moments = roll::within(z);  // (32)
    error_ += ph * (moments.shift / sigma);
    p_ -= ph * ph.transpose() * (moments.shrink / squared(sigma));
  }
}

}  // namespace drydock::study

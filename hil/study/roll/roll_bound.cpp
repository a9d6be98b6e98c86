#include "hil/study/roll/roll_bound.hpp"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>

#include "estimators/roll/antenna.hpp"

namespace drydock::study {
namespace {

using std::numbers::pi;

constexpr double uniform_turn_variance = pi * pi / 3;  // the angle is completely unknown

/// Powers at which the rounded dB value changes, -20 to 8 dB relative to boresight.
std::array<double, 29> rounding_edges() {
  constexpr int weakest_db = -20;
  std::array<double, 29> edges{};
  for (std::size_t i = 0; i < edges.size(); ++i)
    edges[i] = std::pow(10, (weakest_db + static_cast<int>(i) + 0.5) / 10);
  return edges;
}

}  // namespace

double rounded_information(double expected, double sigma) {
  struct Edge {
    double below, density;  // standard normal: probability below the edge, density at it
  };
  const auto edge = [&](double power) {
    const double z = (power - expected) / sigma;
    return Edge{0.5 * std::erfc(-z / std::numbers::sqrt2),
                std::exp(-0.5 * z * z) / std::sqrt(2 * pi)};
  };
  double sum = 0;
  Edge low{0, 0};
  const auto add_up_to = [&](const Edge& high) {
    const double probability = high.below - low.below;
    if (probability > 1e-12)
      sum += (high.density - low.density) * (high.density - low.density) / probability;
    low = high;
  };
  add_up_to(edge(roll_tracking_limit));
  static const auto edges = rounding_edges();
  constexpr double never = 7;  // in sigmas; edges further off have no effect
  for (const double at : edges) {
    if (at > expected + never * sigma) break;
    if (at > expected - never * sigma) add_up_to(edge(at));
  }
  add_up_to({1, 0});
  return sum / (sigma * sigma);
}

std::vector<double> roll_bound(const RollCase& the_case, const RollFlight& flight,
                               double bias_sigma_radps, double bias_noise) {
  const auto& toward = flight.sky().toward_ned;
  const auto satellites = static_cast<Eigen::Index>(toward.size());
  const roll::AntennaOptions antenna;

  // State: roll, gyro bias, common gain, gain of each satellite. A known gain has variance 0.
  Eigen::MatrixXd p = Eigen::MatrixXd::Zero(3 + satellites, 3 + satellites);
  p(0, 0) = uniform_turn_variance;
  p(1, 1) = bias_sigma_radps * bias_sigma_radps;
  p(2, 2) = the_case.gain_sigma * the_case.gain_sigma;
  p.diagonal().tail(satellites).setConstant(std::pow(the_case.satellite_gain_sigma, 2));

  const double dt = roll_gyro_per_epoch / roll_gyro_hz;
  const double white = the_case.gyro_white_degps * pi / 180 / std::sqrt(roll_gyro_hz);
  std::vector<double> variances;
  const auto epochs = static_cast<int>(std::lround(roll_run_s / dt));
  for (int k = 1; k <= epochs; ++k) {
    const double t = k * dt;
    p.row(0) -= dt * p.row(1);  // (34)
    p.col(0) -= dt * p.col(1);
    p(0, 0) += white * white * dt;
    p(1, 1) += bias_noise * bias_noise * dt;
    for (Eigen::Index i = 0; i < satellites; ++i) {
      const auto n = static_cast<std::size_t>(i);
      const roll::SightLine line(toward[n], flight.path(t), antenna.boresight_body);
      const auto power = roll::power_of(antenna, line, flight.true_roll(t));
      const double expected = flight.gain(n) * power.value;
      const double information = the_case.wire ? rounded_information(expected, the_case.power_noise)
                                               : 1 / (the_case.power_noise * the_case.power_noise);
      Eigen::VectorXd h = Eigen::VectorXd::Zero(p.rows());
      h(0) = flight.gain(n) * power.slope;
      h(2) = h(3 + i) = power.value;
      const Eigen::VectorXd ph = p * h;
      p -= ph * ph.transpose() / (h.dot(ph) + 1 / information);  // (35)
    }
    variances.push_back(p(0, 0));
  }
  return variances;
}

}  // namespace drydock::study

#include "estimators/calibration/calibrate.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/calibration/gauss_newton.hpp"
#include "estimators/smoothing/level_smoother.hpp"

namespace drydock::calibration {
namespace {

using smoothing::Dive;
using smoothing::LevelOptions;
using smoothing::Quantity;

constexpr double told_share = 0.3, weak_share = 0.7, confusing = 0.9;
constexpr double wide_gate = 6;

LevelOptions with(const LevelOptions& options, const std::vector<Parameter>& parameters,
                  const Eigen::VectorXd& values) {
  LevelOptions changed = options;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    apply(parameters[i], values(static_cast<Eigen::Index>(i)), changed.sensors);
  return changed;
}

/// The axes inside a gate at `at`. A residual that passes the gate later would change the number of
/// residuals, so the gate is off during the search and these axes alone count.
class Rows {
 public:
  Rows(const Dive& dive, const LevelOptions& options, const LevelOptions& at)
      : dive_(dive), options_(options) {
    const auto residuals = smoothing::level_residuals(dive, at);
    for (std::size_t i = 0; i < residuals.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (residuals[i][axis].known && !residuals[i][axis].used) strip(i, axis);
    options_.gate_sigma = 0;
  }

  Normals at(const std::vector<Parameter>& parameters, const Eigen::VectorXd& values) const {
    const auto residuals = smoothing::level_residuals(dive_, with(options_, parameters, values));
    const auto most = static_cast<Eigen::Index>(3 * residuals.size());
    Normals rows{Eigen::VectorXd(most), Eigen::VectorXd(most)};
    Eigen::Index k = 0;
    for (const auto& axes : residuals)
      for (const auto& axis : axes) {
        if (!axis.known) continue;
        rows.residual(k) = axis.value;
        rows.sigma(k++) = axis.sigma;
      }
    rows.residual.conservativeResize(k);
    rows.sigma.conservativeResize(k);
    return rows;
  }

 private:
  void strip(std::size_t reading, std::size_t axis) {
    dive_.readings[reading].value(static_cast<Eigen::Index>(axis)) = std::nan("");
  }

  Dive dive_;
  LevelOptions options_;
};

bool has(const Dive& dive, Quantity quantity) {
  return std::ranges::find(dive.readings, quantity, &smoothing::Reading::quantity) !=
         dive.readings.end();
}

/// Why a dive does not tell a parameter that no other one hides.
std::string reason(const Parameter& parameter, const Dive& dive) {
  switch (parameter.unknown) {
    case Unknown::yaw:
    case Unknown::scale:
    case Unknown::deviation_constant:
      return has(dive, Quantity::fix) ? "too little way between the fixes"
                                      : "no fix: nothing says where the vehicle really went";
    case Unknown::pitch:
      return has(dive, Quantity::depth) ? "too little way with bottom track and depth"
                                        : "no depth: nothing says how fast the vehicle sank";
    case Unknown::latency: return "what it measures changed too little";
    case Unknown::lever_ahead:
    case Unknown::lever_starboard: return "the vehicle turned too little";
    case Unknown::deviation_sine:
    case Unknown::deviation_cosine:
      return has(dive, Quantity::fix) ? "too few headings, or too little way on them between fixes"
                                      : "no fix: nothing says where the vehicle really went";
  }
  return {};
}

Finding finding_of(const Parameter& parameter, double value, double sigma) {
  Finding finding{parameter, value, sigma, Verdict::not_told, {}, -1};
  const double share = sigma / parameter.prior_sigma;
  if (share < weak_share) finding.verdict = Verdict::weakly;
  if (share < told_share) finding.verdict = Verdict::told;
  return finding;
}

Eigen::MatrixXd correlation_of(const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * covariance * scale.asDiagonal();
}

Eigen::VectorXd priors_of(const std::vector<Parameter>& parameters) {
  Eigen::VectorXd prior(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i)
    prior(static_cast<Eigen::Index>(i)) = parameters[i].prior_sigma;
  return prior;
}

/// Searches from `start` on, with the readings that are inside a gate `widened` times as wide
/// there.
Maximum search(const Dive& dive, const LevelOptions& options,
               const std::vector<Parameter>& parameters, const Eigen::VectorXd& start,
               double widened) {
  LevelOptions at = with(options, parameters, start);
  at.gate_sigma *= widened;
  const Rows rows(dive, options, at);
  return most_likely([&](const Eigen::VectorXd& values) { return rows.at(parameters, values); },
                     priors_of(parameters), start);
}

/// First with a wide gate: a wrong mounting makes good fixes look wild.
Maximum search(const Dive& dive, const LevelOptions& options,
               const std::vector<Parameter>& parameters, const Eigen::VectorXd& start) {
  const auto first = search(dive, options, parameters, start, wide_gate);
  return search(dive, options, parameters, first.value, 1);
}

/// Fits noise and motion with the sensors as `at` has them. The motion is the likeliest one: made
/// larger as for a track it would let the sensors disagree, and the bounds would be those of other
/// residuals.
void fit_again(Dive& dive, LevelOptions& options, const LevelOptions& at,
               const std::vector<smoothing::UnstatedNoise>& unstated,
               std::vector<double>& factors) {
  const auto fit = smoothing::fit_noise(dive, at, unstated);
  options.motion = fit.motion;
  for (std::size_t i = 0; i < unstated.size(); ++i) {
    factors[i] *= fit.factors[i];
    smoothing::scale_noise(dive, unstated[i], fit.factors[i]);
  }
}

}  // namespace

/// Where the search did not settle, the values are not the likeliest and the bounds not theirs.
void judge(Calibration& result, const Dive& dive) {
  for (std::size_t i = 0; i < result.findings.size(); ++i) {
    Finding& finding = result.findings[i];
    if (!result.converged) {
      finding.verdict = Verdict::not_told;
      finding.why = "the search did not settle";
      continue;
    }
    double most = confusing;
    for (std::size_t j = 0; j < result.findings.size(); ++j) {
      const double r =
          std::abs(result.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
      if (j == i || r < most) continue;
      most = r;
      finding.confused_with = static_cast<int>(j);
    }
    if (finding.verdict != Verdict::told)
      finding.why = finding.confused_with >= 0 ? "it cannot be told apart from another parameter"
                                               : reason(finding.parameter, dive);
  }
}

Calibration calibrate(Dive& dive, LevelOptions options, const std::vector<Parameter>& parameters,
                      const std::vector<smoothing::UnstatedNoise>& unstated, bool fit) {
  Calibration result;
  result.noise_factors.assign(unstated.size(), 1);
  options.sigmas.heading_bias_rad = 0;
  options.sigmas.bottom_scale = options.sigmas.log_scale = 0;
  options.motion.heading_bias_rad = 0;
  if (fit) fit_again(dive, options, options, unstated, result.noise_factors);
  Maximum found =
      search(dive, options, parameters, Eigen::VectorXd::Zero(priors_of(parameters).size()));
  if (fit) {
    fit_again(dive, options, with(options, parameters, found.value), unstated,
              result.noise_factors);
    found = search(dive, options, parameters, found.value);
  }
  result.options = with(options, parameters, found.value);
  result.correlation = correlation_of(found.covariance);
  result.iterations = found.iterations;
  result.converged = found.converged;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    result.findings.push_back(
        finding_of(parameters[i], found.value(k), std::sqrt(found.covariance(k, k))));
  }
  judge(result, dive);
  return result;
}

}  // namespace drydock::calibration

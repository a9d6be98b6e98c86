#include "estimators/calibration/calibrate.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/calibration/gauss_newton.hpp"
#include "estimators/calibration/observability.hpp"
#include "estimators/smoothing/level_smoother.hpp"

namespace drydock::calibration {
namespace {

using smoothing::Dive;
using smoothing::LevelOptions;

constexpr double told_share = 0.3, weak_share = 0.7, confusing = 0.9;
constexpr double wide_gate = 6;
constexpr double most_expected = 3;  ///< sigmas of the prior

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

/// Why a dive does not tell a parameter that it might, and that no other one hides.
std::string reason(Unknown unknown) {
  switch (unknown) {
    case Unknown::yaw:
    case Unknown::scale:
    case Unknown::deviation_constant: return "too little way between the fixes";
    case Unknown::pitch: return "too little way with bottom track and depth";
    case Unknown::latency: return "what it measures changed too little";
    case Unknown::lever_ahead:
    case Unknown::lever_starboard: return "the vehicle turned too little";
    case Unknown::deviation_sine:
    case Unknown::deviation_cosine:
      return "too few headings, or too little way on them between fixes";
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

/// The parameters that the readings of a dive may tell, by index, and why not of the others.
struct Observable {
  std::vector<Parameter> parameters;
  std::vector<std::size_t> index;
  std::vector<std::string> why;  ///< by index of all; empty: observable

  Observable(const std::vector<Parameter>& all, const Dive& dive) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      why.push_back(unobservable(all[i], dive));
      if (!why.back().empty()) continue;
      parameters.push_back(all[i]);
      index.push_back(i);
    }
  }
};

/// The others stay as the rig has them, with the sigma of their prior.
Maximum among_all(Maximum found, const Observable& observable, const std::vector<Parameter>& all) {
  const Eigen::VectorXd prior = priors_of(all);
  Eigen::VectorXd value = Eigen::VectorXd::Zero(prior.size());
  Eigen::MatrixXd covariance = prior.cwiseAbs2().asDiagonal();
  for (std::size_t i = 0; i < observable.index.size(); ++i) {
    const auto to = static_cast<Eigen::Index>(observable.index[i]);
    value(to) = found.value(static_cast<Eigen::Index>(i));
    for (std::size_t j = 0; j < observable.index.size(); ++j)
      covariance(to, static_cast<Eigen::Index>(observable.index[j])) =
          found.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
  found.value = value;
  found.covariance = covariance;
  return found;
}

}  // namespace

/// Where the search did not settle, the values are not the likeliest and the bounds not theirs.
void judge(Calibration& result) {
  for (std::size_t i = 0; i < result.findings.size(); ++i) {
    Finding& finding = result.findings[i];
    if (!finding.why.empty()) continue;  // no reading tells it
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
    if (std::abs(finding.value) > most_expected * finding.parameter.prior_sigma) {
      finding.verdict = Verdict::not_told;
      finding.confused_with = -1;
      finding.why =
          "more than 3 sigmas from what the rig says: if it may be so, write about this value into "
          "the rig file and calibrate again";
    } else if (finding.verdict != Verdict::told) {
      finding.why = finding.confused_with >= 0 ? "it cannot be told apart from another parameter"
                                               : reason(finding.parameter.unknown);
    }
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
  const Observable observable(parameters, dive);
  const auto& sought = observable.parameters;
  Maximum found = search(dive, options, sought, Eigen::VectorXd::Zero(priors_of(sought).size()));
  if (fit) {
    fit_again(dive, options, with(options, sought, found.value), unstated, result.noise_factors);
    found = search(dive, options, sought, found.value);
  }
  found = among_all(std::move(found), observable, parameters);
  result.options = with(options, parameters, found.value);
  result.correlation = correlation_of(found.covariance);
  result.iterations = found.iterations;
  result.converged = found.converged;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    result.findings.push_back(
        finding_of(parameters[i], found.value(k), std::sqrt(found.covariance(k, k))));
    result.findings.back().why = observable.why[i];
  }
  judge(result);
  return result;
}

}  // namespace drydock::calibration

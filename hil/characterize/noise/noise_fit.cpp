#include "hil/characterize/noise/noise_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drydock::characterize {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

enum Term : std::uint8_t { quantisation, white, instability, walk };
constexpr std::size_t terms_in_all = 4;

/// The terms of one candidate in the order of the enumeration, and T if a term needs it.
struct Candidate {
  std::vector<Term> terms;
  double correlation_s = 0;
};

double variance_of(Term term, double tau, double correlation_s) {
  switch (term) {
    case quantisation: return 3 / (tau * tau);
    case white: return 1 / tau;
    case instability: return allan_of_gauss_markov(tau, correlation_s);
    case walk: return tau / 3;
  }
  return 0;
}

MatrixXd design_of(const Candidate& candidate, const AllanCurve& curve) {
  MatrixXd design(static_cast<Index>(curve.samples.size()),
                  static_cast<Index>(candidate.terms.size()));
  for (Index i = 0; i < design.rows(); ++i)
    for (Index c = 0; c < design.cols(); ++c)
      design(i, c) = variance_of(candidate.terms[static_cast<std::size_t>(c)],
                                 curve.tau_s(static_cast<std::size_t>(i)), candidate.correlation_s);
  return design;
}

struct Solution {
  Candidate candidate;
  VectorXd squares;  ///< Q^2, N^2, B^2, K^2, as far as the candidate has them
  double deviance = std::numeric_limits<double>::infinity();
};

/// -2 ln likelihood, without a constant, for variances with a chi-square distribution about those
/// of a model.
double deviance(const ArrayXd& measured, const ArrayXd& model, const ArrayXd& freedom) {
  return (freedom * (model.log() + measured / model - measured.log() - 1)).sum();
}

/// Fisher's scoring. For chi-square errors it is least squares weighted by freedom / model^2. The
/// deviance is infinite if a square would be negative.
Solution solve(const Candidate& candidate, const AllanCurve& curve, const ArrayXd& measured,
               const ArrayXd& freedom) {
  constexpr int most_steps = 60;
  constexpr double settled = 1e-9;
  const MatrixXd design = design_of(candidate, curve);
  Solution solution{candidate, {}, {}};
  ArrayXd model = measured;
  for (int step = 0; step < most_steps; ++step) {
    const ArrayXd weight = freedom.sqrt() / model;
    const MatrixXd weighted = design.array().colwise() * weight;
    solution.squares = weighted.colPivHouseholderQr().solve((measured * weight).matrix());
    if (!(solution.squares.minCoeff() > 0))
      return {candidate, {}, std::numeric_limits<double>::infinity()};
    const ArrayXd next = (design * solution.squares).array();
    const bool done = ((next - model).abs() / next).maxCoeff() < settled;
    model = next;
    if (done) break;
  }
  solution.deviance = deviance(measured, model, freedom);
  return solution;
}

/// The best correlation time between a few samples and a share of the recording.
Solution with_best_correlation(Candidate candidate, const AllanCurve& curve,
                               const ArrayXd& measured, const ArrayXd& freedom) {
  const double shortest = 4 * curve.tau_s(0), longest = curve.tau_s(curve.samples.size() - 1);
  const auto at = [&](double log_time) {
    candidate.correlation_s = std::exp(log_time);
    return solve(candidate, curve, measured, freedom);
  };
  double step = std::log(2.0) / 2, centre = std::log(shortest);
  Solution best;
  const int steps = static_cast<int>(std::log(longest / shortest) / step);
  for (int i = 0; i <= steps; ++i)
    if (auto here = at(std::log(shortest) + i * step); here.deviance < best.deviance) {
      best = here;
      centre = std::log(shortest) + i * step;
    }
  constexpr int halvings = 15;  // to 1e-5
  for (int i = 0; i < halvings; ++i, step /= 2)
    for (const double x : {centre - step / 2, centre + step / 2})
      if (auto here = at(x); here.deviance < best.deviance) {
        best = here;
        centre = x;
      }
  return best;
}

/// The sum of terms with the least deviance. Each free figure adds a penalty.
Solution best_of(const NoiseTerms& allowed, const AllanCurve& curve, const ArrayXd& measured,
                 const ArrayXd& freedom) {
  constexpr double price_of_figure = 9;  // three sigma: neighbouring points are not independent
  const std::array<bool, terms_in_all> usable{allowed.quantisation, true, allowed.instability,
                                              allowed.walk};
  Solution best;
  double least = std::numeric_limits<double>::infinity();
  for (unsigned set = 1; set < 1U << terms_in_all; ++set) {
    Candidate candidate;
    bool possible = true;
    for (unsigned t = 0; t < terms_in_all; ++t) {
      if ((set >> t & 1U) == 0) continue;
      possible = possible && usable[t];
      candidate.terms.push_back(static_cast<Term>(t));
    }
    if (!possible) continue;
    const bool timed = (set >> instability & 1U) != 0;
    const auto solution = timed ? with_best_correlation(candidate, curve, measured, freedom)
                                : solve(candidate, curve, measured, freedom);
    const double figures = static_cast<double>(candidate.terms.size()) + (timed ? 1 : 0);
    if (const double cost = solution.deviance + price_of_figure * figures; cost < least) {
      least = cost;
      best = solution;
    }
  }
  return best;
}

NoiseModel model_of(const Solution& solution) {
  NoiseModel model;
  for (std::size_t c = 0; c < solution.candidate.terms.size(); ++c) {
    const double root = std::sqrt(solution.squares[static_cast<Index>(c)]);
    switch (solution.candidate.terms[c]) {
      case quantisation: model.quantisation = root; break;
      case white: model.density = root; break;
      case instability: model.instability = root; break;
      case walk: model.walk = root; break;
    }
  }
  if (model.instability > 0) model.correlation_s = solution.candidate.correlation_s;
  return model;
}

/// Covariance of the logarithms of the squares, and of T after them if there is one. It is that of
/// weighted least squares with correlated data.
MatrixXd scatter(const Solution& solution, const AllanCurve& curve, const MatrixXd& covariance) {
  MatrixXd design = design_of(solution.candidate, curve);
  const ArrayXd model = (design * solution.squares).array();
  if (std::ranges::count(solution.candidate.terms, instability) > 0) {
    constexpr double h = 1e-4;
    Candidate later = solution.candidate;
    later.correlation_s *= std::exp(h);
    const VectorXd slope = (design_of(later, curve) - design) * solution.squares / h;
    design.conservativeResize(Eigen::NoChange, design.cols() + 1);
    design.rightCols<1>() = slope;
  }
  // Everything is relative to the model and to the figures, because both span decades.
  design.leftCols(solution.squares.size()) *= solution.squares.asDiagonal();
  const MatrixXd relative = design.array().colwise() / model;
  const MatrixXd together = (covariance.array().colwise() / model).rowwise() / model.transpose();
  const VectorXd weight = together.diagonal().cwiseInverse();
  const MatrixXd gain = (relative.transpose() * weight.asDiagonal() * relative)
                            .completeOrthogonalDecomposition()
                            .pseudoInverse() *
                        relative.transpose() * weight.asDiagonal();
  return gain * together * gain.transpose();
}

NoiseFit estimates(const Solution& solution, const AllanCurve& curve, const MatrixXd& covariance) {
  NoiseFit fit;
  fit.model = model_of(solution);
  const MatrixXd spread = scatter(solution, curve, covariance);
  const auto sigma = [&](Index i) { return std::sqrt(spread(i, i)); };
  for (std::size_t c = 0; c < solution.candidate.terms.size(); ++c) {
    const auto i = static_cast<Index>(c);
    const auto estimate = deviation_estimate(solution.squares[i], solution.squares[i] * sigma(i));
    switch (solution.candidate.terms[c]) {
      case quantisation: fit.quantisation = estimate; break;
      case white: fit.density = estimate; break;
      case instability: fit.instability = estimate; break;
      case walk: fit.walk = estimate; break;
    }
  }
  if (fit.instability) {
    const double t = fit.model.correlation_s, factor = std::exp(z_95 * sigma(spread.rows() - 1));
    fit.correlation_s = Estimate{t, t / factor, t * factor};
  }
  for (std::size_t i = 0; i < curve.samples.size(); ++i) {
    const auto k = static_cast<Index>(i);
    const double share = curve.variance[i] / fit.model.allan_variance(curve.tau_s(i));
    fit.deviation.push_back(
        deviation_estimate(curve.variance[i], share * std::sqrt(covariance(k, k))));
  }
  return fit;
}

}  // namespace

std::optional<NoiseFit> fit_noise(const AllanCurve& curve, const NoiseTerms& terms) {
  constexpr std::size_t fewest_points = 4;
  if (curve.samples.size() < fewest_points) return std::nullopt;
  const ArrayXd measured =
      Eigen::Map<const ArrayXd>(curve.variance.data(), static_cast<Index>(curve.variance.size()));
  if (!(measured.minCoeff() > 0)) return std::nullopt;
  // The degrees of freedom depend on the noise, and the fit depends on them. The first round uses
  // those of white noise.
  MatrixXd together = covariance(curve, NoiseModel{.density = 1});
  ArrayXd shape(measured.size());
  for (Index i = 0; i < shape.size(); ++i) shape[i] = 1 / curve.tau_s(static_cast<std::size_t>(i));
  Solution solution;
  constexpr int rounds = 2;
  for (int round = 0; round < rounds; ++round) {
    const ArrayXd freedom = 2 * shape.square() / together.diagonal().array();
    solution = best_of(terms, curve, measured, freedom);
    if (solution.squares.size() == 0) return std::nullopt;
    together = covariance(curve, model_of(solution));
    shape = (design_of(solution.candidate, curve) * solution.squares).array();
  }
  return estimates(solution, curve, together);
}

}  // namespace drydock::characterize

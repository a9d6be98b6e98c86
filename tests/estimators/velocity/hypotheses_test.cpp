#include "estimators/velocity/hypotheses.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace drydock::velocity {
namespace {

using Eigen::Vector4d;
using Filter = navigation::ErrorFilter<7>;
using Vector = Filter::Vector;

constexpr int first = 15;
const Vector4d prior{0.5, 0.5, 0.01, 0.02};

struct Seen {
  Vector row;
  double value, sigma;
};

/// Linear measurements of a true state with `true_values` as its four states.
std::vector<Seen> measurements(const Vector4d& true_values, double sigma, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Vector truth = Vector::Zero();
  truth.segment<4>(first) = true_values;
  truth(3) = 0.05;
  std::vector<Seen> all;
  for (int i = 0; i < 40; ++i) {
    Vector row = Vector::Zero();
    row.segment<3>(3) << normal(random), normal(random), normal(random);
    row.segment<4>(first) << normal(random), normal(random), normal(random), normal(random);
    all.push_back({row, row.dot(truth) + sigma * normal(random), sigma});
  }
  return all;
}

struct Learnt {
  Filter filter;
  Vector estimate = Vector::Zero();
  double log_evidence = 0;
};

/// A Kalman filter over these measurements. The densities of its innovations give the evidence.
Learnt learn(const std::vector<Seen>& seen, const Vector4d& sigma) {
  Vector start = 0.1 * Vector::Ones();
  start.segment<4>(first) = sigma;
  Learnt learnt{Filter{start}};
  for (const Seen& m : seen) {
    const auto row = learnt.filter.row(m.row, m.sigma * m.sigma);
    const double innovation = m.row.dot(learnt.estimate) - m.value;
    learnt.log_evidence -=
        0.5 * (std::log(2 * M_PI * row.variance) + innovation * innovation / row.variance);
    learnt.estimate -= learnt.filter.update(row, innovation);
  }
  return learnt;
}

TEST(Hypotheses, AreWeighedAsTheEvidenceOfFourFiltersSays) {
  for (const double size : {0.0, 0.02, 0.05, 0.1}) {
    const auto seen = measurements({size, -size, size / 10, 0}, 0.1, 5);
    std::array<double, 4> evidence;
    for (int h = 0; h < 4; ++h) {
      Vector4d sigma = prior;
      if (h & 1) sigma.head<2>().setZero();
      if (h & 2) sigma.tail<2>().setZero();
      evidence[static_cast<std::size_t>(h)] = learn(seen, sigma).log_evidence;
    }
    double sum = 0, no_first = 0, no_second = 0;
    for (std::size_t h = 0; h < 4; ++h) {
      const double weight = std::exp(evidence[h] - evidence[0]);
      sum += weight;
      if (h & 1) no_first += weight;
      if (h & 2) no_second += weight;
    }
    Learnt all = learn(seen, prior);
    const Weighed weighed = weigh_absence(all.filter, first, all.estimate.segment<4>(first), prior);
    EXPECT_NEAR(weighed.absent[0], no_first / sum, 1e-9) << size;
    EXPECT_NEAR(weighed.absent[1], no_second / sum, 1e-9) << size;
  }
}

TEST(Hypotheses, WithNothingToBeSeenTheStatesAreZeroAndTheOthersKnowIt) {
  const auto seen = measurements(Vector4d::Zero(), 1e-3, 7);
  Learnt all = learn(seen, prior);
  const double before = all.filter.covariance()(3, 3);
  const Weighed weighed = weigh_absence(all.filter, first, all.estimate.segment<4>(first), prior);
  EXPECT_GT(weighed.absent[0], 0.999);
  EXPECT_GT(weighed.absent[1], 0.9);
  EXPECT_LT(all.filter.covariance()(3, 3), before);
  EXPECT_EQ(all.filter.covariance(), all.filter.covariance().transpose());
}

TEST(Hypotheses, WhatIsClearlyThereStaysAsItWas) {
  const auto seen = measurements({0.3, 0.2, 0.05, 0.1}, 1e-3, 9);
  Learnt all = learn(seen, prior);
  const Filter::Covariance before = all.filter.covariance();
  const Weighed weighed = weigh_absence(all.filter, first, all.estimate.segment<4>(first), prior);
  EXPECT_LT(weighed.absent[0] + weighed.absent[1], 1e-6);
  EXPECT_LT(weighed.errors.norm(), 1e-9);
  EXPECT_LT((all.filter.covariance() - before).norm(), 1e-9);
}

}  // namespace
}  // namespace drydock::velocity

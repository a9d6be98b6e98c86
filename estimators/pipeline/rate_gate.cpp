#include "estimators/pipeline/rate_gate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "estimators/pipeline/gate_limits.hpp"

namespace drydock::pipeline {

using measurement::seconds;

namespace {

/// A noisy gyro that gives the same rate so many times stands still.
constexpr int still_samples_of_a_stuck_gyro = 6;

}  // namespace

bool RateGate::believes(measurement::Stamp at, double rate_radps) {
  const Point now{at, rate_radps};
  if (stands_still(rate_radps)) return false;
  if (!good_ || learned_ < gate::learn_samples || reachable(*good_, now)) return take(now);
  agreeing_ = leapt_ && reachable(*leapt_, now) ? agreeing_ + 1 : 1;
  leapt_ = now;
  if (agreeing_ < gate::step_samples && seconds(at - good_->at) < gate::longest_doubt_s)
    return false;
  return take(now);
}

// The mean absolute difference of two normal values is 2 / root pi of their sigma.
double RateGate::noise() const {
  if (learned_ < gate::learn_samples) return std::numeric_limits<double>::infinity();
  return usual_ / (2 * std::numbers::inv_sqrtpi);
}

bool RateGate::stands_still(double rate) {
  still_ = newest_ == rate ? still_ + 1 : 0;
  newest_ = rate;
  return learned_ >= gate::learn_samples && still_ >= still_samples_of_a_stuck_gyro;
}

bool RateGate::reachable(const Point& from, const Point& to) const {
  const double margin = std::max(gate::noise_times * usual_, gate::least_turn);
  return std::abs(to.rate - from.rate) <= margin + spin_up_radps2_ * seconds(to.at - from.at);
}

bool RateGate::take(const Point& now) {
  if (good_ && agreeing_ == 0 && now.rate != good_->rate) {
    double change = std::abs(now.rate - good_->rate);
    if (learned_ >= gate::learn_samples)
      change = std::min(change,
                        gate::most_usual * std::max(usual_, gate::least_turn / gate::noise_times));
    usual_ += std::max(gate::newest_share, 1.0 / (1 + learned_)) * (change - usual_);
    learned_ = std::min(learned_ + 1, gate::learn_samples);
  }
  good_ = now;
  leapt_.reset();
  agreeing_ = 0;
  return true;
}

void RateGate::forget() {
  good_.reset();
  leapt_.reset();
  newest_.reset();
  agreeing_ = still_ = 0;
}

}  // namespace drydock::pipeline

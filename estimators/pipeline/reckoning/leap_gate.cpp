#include "estimators/pipeline/reckoning/leap_gate.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "estimators/pipeline/gate_limits.hpp"

namespace drydock::pipeline {

using measurement::seconds;

LeapGate::Verdict LeapGate::judge(measurement::Stamp at, double value, double rate) {
  const Point now{at, value};
  const double silent_s = good_ ? seconds(at - (leapt_ ? leapt_ : good_)->at) : 0;
  if (!good_ || silent_s > longest_silence_s || silent_s < 0) return take(now, 0);
  const double dt = seconds(at - good_->at);
  const double change = difference(value, good_->value + rate * dt);
  // While it is wild the limit does not grow, or each leap would be within it sooner or later. The
  // first comparison is false for NaN too.
  const double limit = reach(leapt_ ? seconds(leapt_first_ - good_->at) : dt);
  if (std::abs(change) <= limit || learned_ < gate::learn_samples) return take(now, change);
  if (!leapt_) leapt_first_ = at;
  if (!step_lasts(now, rate)) return Verdict::wild;
  stepped_ = difference(stepped_ + change, 0);
  // It took the step back, less what the vehicle did in the meantime.
  if (std::abs(stepped_) <= std::max(reach(0), std::abs(change) / 2)) stepped_ = 0;
  take(now, 0);
  return Verdict::stepped;
}

double LeapGate::difference(double to, double from) const {
  return limits_.angle ? frame::wrap_pi(to - from) : to - from;
}

double LeapGate::reach(double dt) const {
  return std::max(gate::noise_times * usual_, limits_.least) + limits_.change_per_s * dt +
         limits_.change_per_s2 * dt * dt / 2;
}

bool LeapGate::step_lasts(const Point& now, double rate) {
  const double dt = leapt_ ? seconds(now.at - leapt_->at) : 0;
  const bool agrees =
      leapt_ && std::abs(difference(now.value, leapt_->value + rate * dt)) <= reach(dt);
  agreeing_ = agrees ? agreeing_ + 1 : 1;
  if (!agrees) leapt_since_ = now.at;
  leapt_ = now;
  return agreeing_ >= step_samples && seconds(now.at - leapt_since_) >= step_s;
}

double LeapGate::unknown_s(measurement::Stamp at) const {
  return leapt_ ? seconds(at - good_->at) : 0;
}

LeapGate::Verdict LeapGate::take(const Point& now, double change) {
  if (good_ && change != 0) {
    double usual = std::abs(change);
    if (learned_ >= gate::learn_samples)
      usual =
          std::min(usual, gate::most_usual * std::max(usual_, limits_.least / gate::noise_times));
    usual_ += std::max(gate::newest_share, 1.0 / (1 + learned_)) * (usual - usual_);
    learned_ = std::min(learned_ + 1, gate::learn_samples);
  }
  good_ = now;
  leapt_.reset();
  agreeing_ = 0;
  return Verdict::good;
}

}  // namespace drydock::pipeline

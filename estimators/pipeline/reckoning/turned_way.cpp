#include "estimators/pipeline/reckoning/turned_way.hpp"

#include <algorithm>

#include "estimators/frame/attitude.hpp"

namespace drydock::pipeline {

void TurnedWay::begin(double heading_rad, measurement::Stamp at) {
  *this = {};
  heading_rad_ = heading_rad;
  at_ = at;
}

// Simpson's rule.
void TurnedWay::turn_to(double heading_rad, measurement::Stamp at) {
  const double dt = measurement::seconds(at - at_);
  if (dt <= 0) return;
  const double turn = frame::wrap_pi(heading_rad - heading_rad_);
  const auto bow = [&](double share) { return std::polar(1.0, heading_rad_ + share * turn); };
  const double middle = elapsed_s_ + dt / 2, end = elapsed_s_ + dt;
  sum_ += dt / 6 * (bow(0) + 4.0 * bow(0.5) + bow(1));
  moment_ += dt / 6 * (elapsed_s_ * bow(0) + 4 * middle * bow(0.5) + end * bow(1));
  longest_s_ = std::max(longest_s_, dt);
  elapsed_s_ = end;
  heading_rad_ = heading_rad;
  at_ = at;
}

TurnedWay::Horizontal TurnedWay::mean(Horizontal from, Horizontal to) const {
  if (elapsed_s_ <= 0) return 0;
  return (sum_ * from + moment_ / elapsed_s_ * (to - from)) / elapsed_s_;
}

}  // namespace drydock::pipeline

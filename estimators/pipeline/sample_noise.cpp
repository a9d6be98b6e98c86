#include "estimators/pipeline/sample_noise.hpp"

#include <cmath>

namespace drydock::pipeline {

namespace {

constexpr double newest_share = 1 / SampleNoise::samples;

/// Where an interval differs by more than this share from the one before, a sample is missing.
constexpr double uneven = 0.4;

}  // namespace

void SampleNoise::add(const measurement::ImuSample& sample) {
  const double interval_s = measurement::seconds(sample.origin.valid_at - at_);
  Vector6 now;
  now << sample.angular_rate, sample.specific_force;
  const Vector6 change = now - last_;
  const bool even = std::abs(interval_s - interval_s_) <= uneven * interval_s_;
  // The second difference of white noise has six times its variance.
  if (known_ == 2 && even) noise_ += newest_share * ((change - change_).cwiseAbs2() / 6 - noise_);
  at_ = sample.origin.valid_at;
  interval_s_ = interval_s;
  last_ = now;
  change_ = change;
  if (known_ < 2) ++known_;
}

}  // namespace drydock::pipeline

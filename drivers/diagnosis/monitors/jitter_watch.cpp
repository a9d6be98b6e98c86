#include "drivers/diagnosis/monitors/jitter_watch.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::diagnosis {
namespace {

/// The mean of a block is known to a few of its scatters over its length: this much is another
/// rate.
constexpr double most_mean_error = 0.03;
/// Four deviations of the correlation of 150 intervals that know nothing of each other.
constexpr double least_correlation = -0.3;
/// A busy host and an adapter of USB scatter by less.
constexpr double least_jitter_s = 0.015, least_jitter_share = 0.08;

}  // namespace

double JitterWatch::limit_s() const {
  return std::max(least_jitter_s, least_jitter_share * period_s_);
}

void JitterWatch::add(Stamp at) {
  if (period_s_ <= 0) return;
  if (!begun_) begun_ = at;
  if (last_) {
    const double off_s = measurement::seconds(at - *last_) - period_s_;
    sum_ += off_s;
    squares_ += off_s * off_s;
    if (count_++ > 0) products_ += off_s * before_s_;
    before_s_ = off_s;
  } else {
    before_s_ = 0;
  }
  last_ = at;
  if (at - *begun_ >= block && count_ >= fewest) close_block(at);
}

void JitterWatch::interrupt() {
  begun_.reset();
  last_.reset();
  count_ = 0;
  sum_ = squares_ = products_ = 0;
}

void JitterWatch::close_block(Stamp at) {
  const auto scatter_s = judge();
  if (scatter_s && !scatter_s_) since_ = *begun_;
  scatter_s_ = scatter_s;
  interrupt();
  begun_ = last_ = at;
}

std::optional<double> JitterWatch::judge() const {
  const double n = count_, mean = sum_ / n, variance = squares_ / n - mean * mean;
  const double covariance = products_ / (n - 1) - mean * mean;
  if (std::abs(mean) > most_mean_error * period_s_) return {};
  if (variance < limit_s() * limit_s() || covariance > least_correlation * variance) return {};
  return std::sqrt(variance);
}

}  // namespace drydock::diagnosis

#include "drivers/diagnosis/monitors/rate_watch.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::diagnosis {
namespace {

constexpr double block_s = measurement::seconds(RateWatch::block);
constexpr double ppm = 1e-6;
/// So many standard deviations of the slope are significant.
constexpr double significant = 6;
/// Quartz changes its rate by less, hot or cold.
constexpr double possible_ppm = 2000;
constexpr int usual_after_blocks = 150, forgotten_after_blocks = 10;
/// The smallest scatter of the earliest arrivals: the resolution of stamps and timers.
constexpr double least_scatter_s = 20e-6;

}  // namespace

void RateWatch::add(Stamp at, long slots, double period_s) {
  if (!origin_) {
    origin_ = at;
    period_s_ = period_s;
    slot_ = block_number_ = 0;
    in_block_ = 0;
  } else {
    slot_ += slots;
  }
  const double raster_s = static_cast<double>(slot_) * period_s_;
  add(raster_s, measurement::seconds(at - *origin_) - raster_s);
}

void RateWatch::add(Stamp at, std::chrono::nanoseconds own) {
  if (!origin_) {
    origin_ = at;
    own_origin_ = own;
    block_number_ = 0;
    in_block_ = 0;
  }
  const auto own_passed = own - own_origin_;
  add(measurement::seconds(own_passed), measurement::seconds(at - *origin_ - own_passed));
}

void RateWatch::add(double own_s, double late_s) {
  const long number = static_cast<long>(own_s / block_s);
  if (number != block_number_) close_block();
  block_number_ = number;
  earliest_s_ = in_block_++ == 0 ? late_s : std::min(earliest_s_, late_s);
}

void RateWatch::interrupt() {
  origin_.reset();
  known_recent_ = in_block_ = 0;
  change_ppm_.reset();
  if (known_first_ < first_.size()) known_first_ = 0;
}

void RateWatch::close_block() {
  if (in_block_ == 0) return;
  in_block_ = 0;
  if (known_first_ < first_.size()) {
    first_[known_first_++] = earliest_s_;
    if (known_first_ < first_.size()) return;
    const Line line = fit(first_);
    usual_slope_ = line.slope;
    // The variance of a slope over n blocks of the length T: 12 s^2 / (T^2 n (n^2 - 1)).
    constexpr double n = blocks;
    const double sigma =
        std::sqrt(12 / (n * (n * n - 1))) * std::max(line.scatter_s, least_scatter_s) / block_s;
    limit_ppm_ = std::max(least_ppm, significant * sigma / ppm);
    return;
  }
  std::rotate(recent_.begin(), recent_.begin() + 1, recent_.end());
  recent_.back() = earliest_s_;
  known_recent_ = std::min(known_recent_ + 1, recent_.size());
  note_change(change_now());
}

void RateWatch::note_change(std::optional<double> change_ppm) {
  change_ppm_ = change_ppm;
  if (!change_ppm || std::abs(*change_ppm - steady_ppm_) > limit_ppm_) {
    steady_ppm_ = change_ppm.value_or(0);
    steady_blocks_ = 0;
    return;
  }
  if (++steady_blocks_ <
      (std::abs(steady_ppm_) > possible_ppm ? forgotten_after_blocks : usual_after_blocks))
    return;
  interrupt();
  known_first_ = 0;
  steady_blocks_ = 0;
}

std::optional<double> RateWatch::change_now() const {
  if (known_recent_ < recent_.size()) return {};
  const Line line = fit(recent_);
  const double change = (usual_slope_ - line.slope) / ppm;
  // A jump of the raster is no drift: the line must fit. A jump between five blocks scatters by
  // nine tenths of its slope.
  constexpr double straight = 0.4;
  const bool fits = line.scatter_s < straight * std::abs(line.slope - usual_slope_) * block_s;
  if (std::abs(change) < limit_ppm_ || !fits) return {};
  return change;
}

template <std::size_t N>
RateWatch::Line RateWatch::fit(const std::array<double, N>& y) {
  constexpr double n = N;
  double mean = 0, product = 0;
  for (std::size_t i = 0; i < N; ++i) mean += y[i] / n;
  for (std::size_t i = 0; i < N; ++i)
    product += (static_cast<double>(i) - (n - 1) / 2) * (y[i] - mean);
  const double per_block = product * 12 / (n * (n * n - 1));
  double squares = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const double off = y[i] - mean - per_block * (static_cast<double>(i) - (n - 1) / 2);
    squares += off * off;
  }
  return {per_block / block_s, std::sqrt(squares / (n - 2))};
}

}  // namespace drydock::diagnosis

#include "drivers/diagnosis/monitors/quantity_monitor.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::diagnosis {
namespace {

/// A second difference beyond so many deviations is an event: 0.3 % of white noise, 55 % of noise
/// five times as strong.
constexpr double beyond = 3;
constexpr double pulse_beyond = 8, neighbours_within = 4;
constexpr double step_beyond = 6;
constexpr double rate_memory = 16;  // samples
/// Behind a pause of so many periods nothing is known of the sample before.
constexpr double longest_pause = 4;
/// From the second difference x0 - 2 x1 + x2 of white noise to its own deviation.
const double noise_of_bend = std::sqrt(6.0);
/// Samples whose scatter is told to a tenth.
constexpr std::size_t well_known = 120, refined_every = 30;
constexpr double median_of_normal = 0.6745, q95_of_normal = 1.96;

}  // namespace

double QuantityMonitor::minus(double a, double b) const {
  const double difference = a - b;
  return facts_of(quantity_).angle ? std::remainder(difference, 2 * std::numbers::pi) : difference;
}

QuantityMonitor::News QuantityMonitor::add(double value, Stamp at) {
  const double period_s = samples_ > 0 ? measurement::seconds(at - last_at_) : 0;
  if (is_pause(period_s)) samples_ = 0;
  last_ = {value, last_[0], last_[1], last_[2]};
  last_at_ = at;
  samples_ = std::min(samples_ + 1, 4U);
  took_s_ = {period_s, took_s_[0], took_s_[1]};
  if (samples_ == 4 && took_s_[2] > 0)
    rate_ += (minus(last_[2], last_[3]) / took_s_[2] - rate_) / rate_memory;
  if (samples_ < 3) return {};
  const double bend = minus(last_[0], last_[1]) - minus(last_[1], last_[2]);
  News news;
  const auto coarse = resolution_.add(bend, at);
  if (known_)
    news = judge(period_s, at);
  else
    learn(bend, at, period_s);
  news.coarse = coarse.value_or(0);
  return news;
}

/// While it still learns, only a pause of more than a second is looked at.
bool QuantityMonitor::is_pause(double period_s) {
  if (known_) return period_s > longest_pause * usual_period_s_;
  return period_s > 1 && periods_.count() > 0 && period_s > longest_pause * periods_.quantile(0.5);
}

void QuantityMonitor::learn(double bend, Stamp at, double period_s) {
  if (!first_) first_ = at;
  const double was = minus(last_[1], last_[2]), is = minus(last_[0], last_[1]);
  if (was != 0 && is != 0) {
    ++moves_;
    if ((was < 0) != (is < 0)) ++turns_;
  }
  bends_.add(std::abs(bend));
  if (bend != 0) smallest_bend_ = std::min(smallest_bend_, std::abs(bend));
  periods_.add(period_s);
  if (at - *first_ < learning || bends_.count() < fewest) return;
  usual_period_s_ = periods_.quantile(0.5);
  scatter_ = scatter_of_bends();
  // White noise turns at two of three samples, a smooth motion hardly ever.
  constexpr double turning = 0.35;
  constexpr unsigned fewest_moves = 15;
  noise_shows_ = moves_ >= fewest_moves && turns_ > turning * moves_;
  hold_to_grade();
  set_sigma();
  known_ = true;
}

/// Numbers come in steps of the sensor's resolution: the true quantile may lie half a step above.
double QuantityMonitor::half_step() const {
  return std::isfinite(smallest_bend_) ? smallest_bend_ / 2 : 0;
}

double QuantityMonitor::scatter_of_bends() {
  return std::max((bends_.quantile(0.5) + half_step()) / median_of_normal,
                  (bends_.quantile(0.95) + half_step()) / q95_of_normal);
}

/// Thirty samples of one in a hundred sensors scatter by a third less than all. So slow sensors go
/// on to learn, from what does not look like noise that rose.
void QuantityMonitor::refine(double bend) {
  if (bends_.count() >= well_known || noise_.sum() > 0) return;
  bends_.add(std::abs(bend));
  if (bends_.count() % refined_every != 0) return;
  scatter_ = std::max(scatter_, scatter_of_bends());
  set_sigma();
}

void QuantityMonitor::set_sigma() {
  sigma_ =
      std::max(scatter_, facts_of(quantity_).bend * usual_period_s_ * usual_period_s_ / beyond);
  trembling_ = facts_of(quantity_).tremble == 0
                   ? std::numeric_limits<double>::infinity()
                   : std::max(scatter_, facts_of(quantity_).tremble * usual_period_s_ *
                                            usual_period_s_ / beyond);
}

/// Noise that is far above the grade from the start on is not usual.
void QuantityMonitor::hold_to_grade() {
  if (grade_ <= 0 || !noise_shows_) return;
  const double graded = noise_of_bend * std::hypot(grade_, 2 * half_step());
  const double moved = facts_of(quantity_).bend * usual_period_s_ * usual_period_s_ / beyond;
  if (bends_.quantile(0.5) / median_of_normal < beyond * std::max(graded, moved)) return;
  scatter_ = graded;
  noise_.add(true, *first_);
}

QuantityMonitor::News QuantityMonitor::judge(double period_s, Stamp at) {
  News news;
  const auto& facts = facts_of(quantity_);
  const double into = minus(last_[1], last_[2]), out_of = minus(last_[0], last_[1]);
  const double around = std::abs(minus(last_[0], last_[2]));
  const double off = (into - out_of) / 2;
  const bool returns = into * out_of < 0 && around < std::abs(off) / 2;
  if (returns && std::abs(off) > std::max(facts.wild, pulse_beyond * scatter_)) news.wild = off;
  if (returns && std::abs(off) > pulse_beyond * sigma_ && around < neighbours_within * sigma_)
    news.pulse = off;
  if (news.wild != 0 || news.pulse != 0) {
    // Without it, so that one sample does not look like noise.
    last_[1] = last_[2] + minus(last_[0], last_[2]) / 2;
    return news;
  }
  judge_noise(out_of - into, at);
  refine(out_of - into);
  news.noisy = noise_.fired();
  if (samples_ < 4 || facts.slope == 0 || period_s <= 0) return news;
  const double noise = step_beyond * sigma_ / noise_of_bend * std::numbers::sqrt2;
  const auto limit = [&](double took_s) { return facts.slope * std::max(took_s, 0.05) + noise; };
  const double before = minus(last_[2], last_[3]);
  const double step = into - rate_ * took_s_[1];
  if (std::abs(step) > limit(took_s_[1]) &&
      std::abs(out_of - rate_ * took_s_[0]) < limit(took_s_[0]) / 2 &&
      std::abs(before - rate_ * took_s_[2]) < limit(took_s_[2]) / 2) {
    news.jump = step;
    news.most = limit(took_s_[1]);
  }
  return news;
}

double QuantityMonitor::usual_change() const {
  // Three deviations of second differences are five of the change of white noise.
  return beyond * sigma_ + 2 * std::abs(rate_) * usual_period_s_;
}

void QuantityMonitor::judge_noise(double bend, Stamp at) {
  if (!noise_shows_) return;
  // What no motion makes is no noise either: wild samples in a row, steps.
  if (std::abs(bend) > std::max(facts_of(quantity_).wild, 2 * step_beyond * beyond * sigma_))
    return;
  // A motion that begins bends one way for some samples. Noise does not: the second differences of
  // white noise have the correlation -2/3.
  // What goes to and fro from sample to sample is no motion even if it is small.
  const bool turned = bend * last_bends_[0] < 0;
  const bool to_and_fro = turned && last_bends_[0] * last_bends_[1] < 0;
  last_bends_ = {bend, last_bends_[0]};
  const double limit = beyond * (to_and_fro ? std::min(sigma_, trembling_) : sigma_);
  noise_.add(turned && std::abs(bend) > limit, at);
}

}  // namespace drydock::diagnosis

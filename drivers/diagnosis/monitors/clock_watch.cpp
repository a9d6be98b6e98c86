#include "drivers/diagnosis/monitors/clock_watch.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::diagnosis {
namespace {

constexpr std::size_t fewest_offsets = 10;
constexpr double least_limit_s = 0.05;
/// A clock that shows the time of day, of the week or a counter starts again at such a jump.
constexpr double longest_jump_s = 40'000;
/// A sound clock gains or loses by so much against the host's: 1 s in 83 minutes.
constexpr double own_rate = 200e-6;

}  // namespace

ClockWatch::News ClockWatch::add(std::chrono::nanoseconds device, Stamp arrival, Stamp valid_at) {
  News news;
  news.backwards = last_ && device < *last_;
  news.repeated = last_ && device == *last_;
  last_ = device;
  const double age_s = measurement::seconds(arrival - valid_at);
  const double offset_s = measurement::seconds(arrival.time_since_epoch() - device);
  if (!known_) {
    goes_back_when_sound_ |= news.backwards;
    repeats_when_sound_ |= news.repeated;
    learn(offset_s, age_s, arrival);
    return {};
  }
  news.backwards &= !goes_back_when_sound_;
  news.repeated &= !repeats_when_sound_;
  latest_s_ = offset_s - base_s_;
  if (std::abs(latest_s_ - usual_s_) > longest_jump_s) accept();
  const double jump_s = latest_s_ - usual_s_;
  if (std::abs(jump_s) > limit_s_) news.jump_s = jump_s;
  news.aged = std::abs(age_s - usual_age_s_ - jump_s) < limit_s_;
  if (news.jump_s == 0) keep_pace(jump_s, arrival);
  return news;
}

void ClockWatch::keep_pace(double jump_s, Stamp arrival) {
  const double most_s = own_rate * measurement::seconds(arrival - before_.value_or(arrival));
  usual_s_ += std::clamp(jump_s / 16, -most_s, most_s);
  before_ = arrival;
}

void ClockWatch::accept() { usual_s_ = latest_s_; }

void ClockWatch::learn(double offset_s, double age_s, Stamp arrival) {
  if (!first_) {
    first_ = arrival;
    base_s_ = offset_s;
  }
  offsets_.add(offset_s - base_s_);
  ages_.add(age_s);
  if (arrival - *first_ < learning || offsets_.count() < fewest_offsets) return;
  usual_s_ = offsets_.quantile(0.5);
  usual_age_s_ = ages_.quantile(0.5);
  const double scatter_s = offsets_.quantile(0.95) - offsets_.quantile(0.05);
  limit_s_ = std::max(least_limit_s, 3 * scatter_s);
  known_ = true;
}

}  // namespace drydock::diagnosis

#include "drivers/diagnosis/monitors/raster.hpp"

#include <algorithm>
#include <utility>

namespace drydock::diagnosis {
namespace {

constexpr double crowded_share = 0.4;  ///< of a period
constexpr double most_crowded_share = 0.65;
/// A host is late by so much now and then, and a slow line holds a message behind another one.
constexpr double least_tolerance_s = 0.002, least_tolerance_share = 0.05;
constexpr double most_tolerance_share = 0.3;
/// A period is the mean of its intervals, but for those that were lost.
constexpr double most_mean = 1.3;
/// Lost messages leave the others on their places: those scatter by less than any odd stream.
constexpr double most_folded_share = 0.15;
/// A stream that loses more has another rate.
constexpr double most_missing_share = 0.7;
/// What comes sooner is another message right behind.
constexpr double most_early_share = 0.5;

}  // namespace

Raster::Arrival Raster::add(Stamp at, double behind_s, HostLate host) {
  if (state_ != State::known) {
    learn(at, behind_s);
    return {};
  }
  const double begun_late_s = std::exchange(begun_late_s_, last_ ? 0 : host.now_s);
  if (!last_) {
    last_ = any_ = at;
    owed_ = 0;
    return {};
  }
  const Stamp last = *last_;
  const double off_s = measurement::seconds(at - last) - period_s_;
  Arrival arrival = judge(at);
  arrival.host_held = arrival.step == Step::crowded && host.lately_s + tolerance_s_ > period_s_;
  const bool is_late = off_s > tolerance_s_ && may_be_late(host, off_s, arrival.step);
  const bool is_early = off_s < -tolerance_s_ && off_s > -most_early_share * period_s_ &&
                        -off_s <= begun_late_s + host.lately_s + tolerance_s_;
  if (!is_late && !is_early) return arrival;
  last_ = is_late ? last + measurement::from_seconds(period_s_) : at;
  owed_ = 0;
  return {.step = Step::regular, .interval_s = period_s_, .slots = 1};
}

/// While the computer is busy, others of it hold messages that this program is ready to take. Only
/// if this program was late as well, a message in the place of the next is none behind a lost one.
bool Raster::may_be_late(HostLate host, double off_s, Step step) const {
  if (step == Step::missing && host.now_s == 0) return false;
  return off_s <= host.now_s + host.lately_s + tolerance_s_;
}

Raster::Arrival Raster::judge(Stamp at) {
  Arrival arrival;
  arrival.interval_s = measurement::seconds(at - *last_);
  const double since_any_s = measurement::seconds(at - any_);
  any_ = at;
  if (is_crowded(arrival.interval_s, since_any_s)) {
    arrival.step = Step::crowded;
    owed_ = std::max(owed_ - 1, 0L);
    return arrival;
  }
  last_ = at;
  arrival.slots = std::lround(arrival.interval_s / period_s_);
  const double off = arrival.interval_s - static_cast<double>(arrival.slots) * period_s_;
  const bool fits = arrival.slots > 0 && std::abs(off) <= tolerance_s_;
  // In 5.4 periods a line that holds messages takes five or six.
  const long most = std::lround(std::ceil(arrival.interval_s / period_s_));
  owed_ = std::max((fits ? arrival.slots : most) - 1, 0L);
  arrival.step = !fits ? Step::odd : arrival.slots == 1 ? Step::regular : Step::missing;
  return arrival;
}

/// What was held comes out as fast as the line can.
bool Raster::is_crowded(double interval_s, double since_any_s) const {
  const double limit_s =
      std::min(crowded_share * period_s_ + allowed_s_, most_crowded_share * period_s_);
  return interval_s < limit_s || (owed_ > 0 && since_any_s < limit_s);
}

void Raster::learn(Stamp at, double behind_s) {
  if (state_ == State::has_none) return;
  if (!first_) first_ = at;
  if (last_) {
    const double interval_s = measurement::seconds(at - *last_);
    intervals_.add(interval_s);
    learned_s_ += interval_s;
    ++intervals_learned_;
    if (first_missing_ == Stamp{} && interval_s > 1.5 * nominal_s_) first_missing_ = *last_;
  }
  behind_.add(behind_s);
  last_ = at;
  if (at - *first_ >= learning && intervals_.count() >= fewest) settle();
}

void Raster::settle() {
  const bool is_even = has_little_scatter(most_tolerance_share) || fold();
  // Frames of one long message: the few long intervals between them are no scatter of the short.
  const double mean_s = (1 - missing_share_) * learned_s_ / static_cast<double>(intervals_learned_);
  const bool has_raster = is_even && mean_s < most_mean * period_s_;
  state_ = has_raster ? State::known : State::has_none;
  waits_s_ = behind_.quantile(0.5);
  if (waits_s_ > crowded_share * period_s_) waits_s_ = 0;
}

/// Takes the median for the period, and the scatter about it for the tolerance.
bool Raster::has_little_scatter(double most_share) {
  period_s_ = intervals_.quantile(0.5);
  const double early_s = period_s_ - intervals_.quantile(0.05);
  const double late_s = intervals_.quantile(0.95) - period_s_;
  const double scatter_s = std::max(early_s, late_s);
  const double least_s = std::max(least_tolerance_s, least_tolerance_share * period_s_);
  tolerance_s_ = std::min(std::max(3 * scatter_s, least_s), most_tolerance_share * period_s_);
  return period_s_ > 0 && scatter_s < most_share * period_s_;
}

/// Lost messages make intervals of whole periods. Taken for single ones they show the raster.
bool Raster::fold() {
  if (nominal_s_ <= 0) return false;
  Spread<256> single;
  double came = 0, due = 0;
  for (const float interval_s : intervals_.kept()) {
    const double periods = std::max(1.0, std::round(interval_s / nominal_s_));
    single.add(interval_s - (periods - 1) * nominal_s_);
    came += 1;
    due += periods;
  }
  intervals_ = single;
  missing_share_ = 1 - came / due;
  return missing_share_ < most_missing_share && has_little_scatter(most_folded_share);
}

void Raster::allow(double line_s) {
  allowed_s_ = line_s;
  if (state_ == State::known)
    tolerance_s_ = std::max(tolerance_s_, std::min(line_s, most_tolerance_share * period_s_));
}

}  // namespace drydock::diagnosis

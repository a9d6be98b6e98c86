#include "estimators/consistency/test.hpp"

namespace drydock::consistency {
namespace {

using diagnosis::Sign;

constexpr double follow_s = 10;   // time constant of the offset, within the bound of its rate
constexpr int first_memory = 15;  // samples: a sum may drift while its offset is learned
constexpr double trend_s = 60;    // and of its trend
constexpr std::chrono::seconds outage{3};
constexpr std::chrono::seconds kept_for{20};
constexpr double steady_for_s = 5;   // at least
constexpr double small_rest = 0.25;  // of the largest deviation
/// Sigmas by which a fault that goes on had moved its sum meanwhile: others err by some of them.
constexpr double still_going = 10;
/// A sum that stays within two sigmas meanwhile wanders by less than half of what sound ones may.
/// A sigma that was learned in a fault may be large: then it need not stay for ever.
constexpr double still_wandering = 4, shortest_rest_s = 30, longest_rest_s = 60;
/// An offset that is younger may be of the fault that is found; what rests for so long is no noise.
constexpr std::chrono::seconds young{60};
constexpr double rests_for_s = 10;
// Fired samples; then the shape is told. Of two witnesses the named one soon counts no more, which
// changes the residual.
constexpr int told_after = 15, told_after_of_pair = 6;
constexpr double spread_samples = 300;  // memory of the spread
constexpr double noise_samples = 10;    // memory of the noise from sample to sample
constexpr double wildest = 10;          // sigmas; more does not count as noise

/// Of the deviation: so far the others have moved at least from what has stopped.
constexpr double moved_share = 0.5;
constexpr double late_share = 0.4;  // what a latency leaves of what a step or a ramp leaves

/// What scatters so much in its first samples may have been at fault in some: it learns once more.
constexpr double wide_floors = 5;

double square(double x) { return x * x; }

/// While other errors are large, a deviation is theirs: it teaches little of the usual spread.
double own_share(const Residual& residual, double usual) {
  return square(usual) / (square(usual) + square(residual.sigma));
}

}  // namespace

void Test::take(const Residual& residual, Stamp at) {
  const double before = deviation_;
  if (at - last_ > outage && !fired_) cusum_.clear();
  const double dt = std::clamp(measurement::seconds(at - last_), 0.0, 1.0);
  last_ = at;
  if (!learned()) return residual.at_fault ? void() : learn(residual, dt);
  deviation_ = residual.value - learned_.offset;
  const double usual = spread();
  const double most = square(wildest * usual);
  noise_square_ +=
      (std::min(square(deviation_ - before) / 2, most) - noise_square_) / noise_samples;
  sigma_ = sigma_of(residual, usual);
  test(residual, at);
  if (fired_) return end_fault(at);
  if (residual.at_fault) return;
  learned_.mean_square += own_share(residual, usual) *
                          (std::min(square(deviation_), most / 4) - learned_.mean_square) /
                          spread_samples;
  follow(residual, dt);
  keep(at);
}

void Test::restart() {
  samples_ = 0;
  kept_ = {};
}

/// Of two states the older one was there before any fault that is found within `kept_for`.
void Test::keep(Stamp at) {
  if (at - kept_[0].at < kept_for) return;
  kept_ = {learned_, kept_[0]};
  kept_[0].at = at;
}

const Test::Learned* Test::kept_before(Stamp since) const {
  const auto before = std::ranges::find_if(
      kept_, [&](const Learned& one) { return one.at != Stamp{} && one.at <= since; });
  return before == kept_.end() ? nullptr : &*before;
}

void Test::forget(Stamp since) {
  const Learned* before = kept_before(since);
  cusum_.clear();
  fired_ = false;
  const bool beside_sum = facts_.others_wander > 0;
  if (facts_.sum_above <= 0 || beside_sum || before == nullptr) return restart();
  learned_ = *before;
  noise_square_ = 0;
}

void Test::acquit(Stamp since) {
  if (cusum_.value() <= 0 || since_ < since) return;
  cusum_.clear();
  fired_ = false;
  if (facts_.sum_above <= 0) restart();
}

void Test::learn(const Residual& residual, double dt) {
  if (samples_ == 0) {
    learned_.offset = residual.value;
    learned_.mean_square = noise_square_ = 0;
    cusum_.clear();
    fired_ = false;
    learned_.trend = 0;
    learned_.passing = {};
    first_.clear();
  }
  ++samples_;
  first_.add(residual.value);
  deviation_ = residual.value - learned_.offset;
  learned_.mean_square +=
      own_share(residual, facts_.floor) * (square(deviation_) - learned_.mean_square) / samples_;
  learned_.offset +=
      deviation_ * (facts_.passes ? learned_.passing.take(facts_.floor, residual.sigma, dt)
                                  : 1.0 / std::min(samples_, first_memory));
  if (learned()) learns_again_ = !learns_again_ && spread() > wide_floors * facts_.floor;
  if (learned() && !drifts()) {
    learned_.offset = first_.median();
    learned_.mean_square = first_.mean_square();
  }
  if (learns_again_ && learned()) samples_ = 0;
  learned_at_ = last_;
  young_up_.reset();
}

/// A sum, what is compared with one, and what errs by the same for long: there the last of the
/// first samples tell the offset, not the middle one.
bool Test::drifts() const {
  return facts_.sum_above <= 0 || facts_.others_wander > 0 || facts_.passes;
}

/// The offset of a healthy sensor moves slowly: temperature, current, mounting, tide.
void Test::follow(const Residual& residual, double dt) {
  if (facts_.passes && !learned_.passing.is_known(facts_.floor))
    learned_.offset += deviation_ * learned_.passing.take(facts_.floor, residual.sigma, dt);
  const double most = facts_.wander * dt;
  learned_.trend = std::clamp(learned_.trend + deviation_ * dt / (follow_s * trend_s),
                              -facts_.trend, facts_.trend);
  learned_.offset += std::clamp(deviation_ * dt / follow_s, -most, most) + learned_.trend * dt;
}

/// A fault that is over leaves a residual that stays where it is: it begins anew.
void Test::end_fault(Stamp at) {
  if (young_up_ == cusum_.is_up()) young_at_ = at;
  if (std::abs(deviation_ - steady_) > 2 * sigma_) {
    steady_ = deviation_;
    steady_since_ = at;
  }
  const double steady_s = measurement::seconds(at - steady_since_);
  if (steady_s <= steady_for_s) return;
  if (is_over(steady_s) || was_learned_in_fault(steady_s)) return restart();
  if (steady_s <= rests_for_s || (deviation_ > 0) == fired_up_) return;
  if (have_others_followed()) return restart();
  const Learned* before = kept_before(since_);
  if (before == nullptr || !is_where_it_was(*before)) return;
  learned_ = *before;
  cusum_.clear();
  fired_ = false;
}

/// The offset followed the begin of the fault by some sigmas, and now the residual rests on the
/// other side of it, much nearer to where it was before.
bool Test::is_where_it_was(const Learned& before) const {
  const double from_before = learned_.offset + deviation_ - before.offset;
  return facts_.sum_above > 0 && facts_.others_wander <= 0 &&
         std::abs(from_before) < small_rest * std::abs(deviation_);
}

/// The others' offsets followed its fault, so now it rests on the other side of them.
bool Test::have_others_followed() const {
  if (facts_.others_wander <= 0) return false;
  const double fault_s = measurement::seconds(steady_since_ - since_ + kept_for);
  return std::abs(steady_) < (facts_.wander + facts_.others_wander) * fault_s + 2 * spread();
}

/// An alarm rose just behind the learning, and soon after it the residual rests on the other side
/// of the offset: so part of the fault was learned.
bool Test::was_learned_in_fault(double steady_s) const {
  return young_up_ && *young_up_ != cusum_.is_up() && since_ - young_at_ < young &&
         steady_s > rests_for_s;
}

/// A sum stayed for long enough when the fault, at the mean rate of its rise, would have moved it
/// clearly. One beside a sum is back but for what that moved
/// meanwhile.
bool Test::is_over(double steady_s) const {
  const double rise_s = std::max(1.0, measurement::seconds(steady_since_ - since_));
  const double left = std::abs(steady_);
  if (facts_.sum_above <= 0)
    return left / rise_s * steady_s > still_going * sigma_ ||
           steady_s > std::clamp(still_wandering * sigma_ / facts_.wander, shortest_rest_s,
                                 longest_rest_s);
  if (facts_.others_wander <= 0) return false;
  const double moved = (facts_.wander + facts_.others_wander) * (rise_s + steady_s);
  return left < small_rest * std::abs(peak_) && left < moved + spread();
}

double Test::spread() const {
  return std::sqrt(std::max(square(facts_.floor), learned_.mean_square));
}

double Test::sigma_of(const Residual& residual, double spread) const {
  const double of_offset = facts_.passes ? learned_.passing.variance(facts_.floor) : 0;
  return std::sqrt(std::max(square(spread), noise_square_) + square(facts_.late_s * residual.rate) +
                   square(residual.sigma) + of_offset);
}

/// An alarm ends because the residual is back, not because less is known now than usual.
bool Test::is_blind(const Residual& residual) const {
  const double known = sigma_of({.rate = residual.rate}, spread());
  const double away = std::abs(deviation_);
  return facts_.holds && fired_ && away > design.reference * known &&
         away < design.reference * sigma_;
}

void Test::test(const Residual& residual, Stamp at) {
  const bool was_quiet = cusum_.value() <= 0;
  late_.note(residual.quantity, at);
  if (!is_blind(residual)) cusum_.take(deviation_ / sigma_, design);
  if (cusum_.value() <= 0) {
    fired_ = false;
    usual_rate_ = residual.rate;
    usual_quantity_ = residual.quantity;
    return;
  }
  if (was_quiet || std::abs(deviation_ / sigma_) > std::abs(peak_ / peak_sigma_)) {
    peak_ = deviation_;
    peak_sigma_ = sigma_;
  }
  moved_ = std::max(was_quiet ? 0 : moved_, std::abs(residual.quantity - usual_quantity_));
  if (was_quiet) {
    shape_.clear();
    late_.clear();
    fired_samples_ = 0;
    since_ = at;
    return;  // it may lie between the last sound sample and the first wrong one
  }
  if (cusum_.value() >= design.limit && !fired_) {
    fired_ = true;
    fired_up_ = cusum_.is_up();
    if (!young_up_ && since_ - learned_at_ < young) young_up_ = cusum_.is_up();
    steady_ = deviation_;
    steady_since_ = at;
  }
  const int enough = residual.pair ? told_after_of_pair : told_after;
  if (fired_ && ++fired_samples_ > enough && late() != Late::open) return;
  const double change = residual.rate - usual_rate_;
  late_.take(deviation_, change, facts_.floor);
  const double rate = residual.shapes ? change : 0;
  const double quantity =
      residual.shapes && facts_.scales ? residual.quantity - usual_quantity_ : 0;
  shape_.take(deviation_, measurement::seconds(at - since_) + 0.1, rate, quantity);
}

bool Test::has_stopped(const Freeze* own) const {
  return own != nullptr && own->since() && *own->since() < since_ + std::chrono::seconds{1} &&
         last_ - *own->since() > std::chrono::seconds{1};
}

Test::Late Test::late() const {
  if (!facts_.may_be_late) return Late::no;
  // The offset may have been learned in a turn: then it is off when the turn is over.
  if (late_.is_possible() && late_.left_over() < late_share * shape_.left_over()) return Late::yes;
  return late_.is_contradicted() ? Late::no : Late::open;
}

bool Test::is_open(const Freeze* own) const { return late() == Late::open && !has_stopped(own); }

Sign Test::sign(const Freeze* own) const {
  const bool moved = !facts_.is_often_equal || moved_ > moved_share * std::abs(peak_);
  if (has_stopped(own) && own->jumped()) return Sign::offset;
  if (has_stopped(own) && moved) return Sign::stuck;
  if (late() == Late::yes) return Sign::delayed;
  switch (shape_.best()) {
    case Shape::step: return facts_.sum_above > 0 ? Sign::offset : Sign::step;
    case Shape::ramp:
      return std::abs(shape_.amount(Shape::ramp)) > facts_.sum_above ? Sign::offset : Sign::ramp;
    case Shape::parabola: return Sign::ramp;
    case Shape::delayed: return Sign::delayed;
    case Shape::scaled: return Sign::scale;
  }
  return Sign::offset;
}

}  // namespace drydock::consistency

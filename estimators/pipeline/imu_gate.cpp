#include "estimators/pipeline/imu_gate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drivers/measurement/units.hpp"
#include "estimators/pipeline/gate_limits.hpp"

namespace drydock::pipeline {

using measurement::seconds;

namespace {

/// Standard deviation of a normal value over its mean absolute value, the root of pi / 2.
constexpr double per_mean_size = 1.2533;

/// As gate::least_turn, m/s2.
constexpr double least_force = 0.02;

/// So many equal samples in a row were those of a sensor that stood still. Noise makes that
/// improbable.
constexpr int still_samples = 5;

/// Changes behind a leap that are so many times as large as usual are noise. Seven changes of an
/// IMU that is as noisy as before have such a mean once in 3000 runs.
constexpr double restless_times = 2;

/// A value that turns back at two changes in five or more is noisy; white noise does at two in
/// three. If so many samples in a row are equal in all six values and one of them was noisy, the
/// IMU is stuck.
constexpr double noisy_turns = 0.4;
constexpr int stuck_samples = 20;

/// True if the three gyros or the three accelerometers, whichever leapt, have exactly the same
/// values.
template <class Vector>
bool equal_where_leapt(const Vector& leap, const Vector& margin, const Vector& a, const Vector& b) {
  const auto same = [&](int at) {
    const bool leapt =
        (leap.template segment<3>(at).cwiseAbs().array() > margin.template segment<3>(at).array())
            .any();
    return !leapt || a.template segment<3>(at) == b.template segment<3>(at);
  };
  return same(0) && same(3);
}

}  // namespace

ImuGate::Verdict ImuGate::judge(const measurement::ImuSample& sample) {
  Point now{sample.origin.valid_at, {}};
  now.values << sample.angular_rate, sample.specific_force;
  if (!possible(now.values) || frozen(now.values)) return Verdict::wild;
  if (good_ && learned_ >= gate::learn_samples && (goes_on(now) || !reachable(*good_, now)))
    return doubt(now);
  learn(now);
  if (stands_still()) {
    stuck_at_ = now.values;
    return Verdict::wild;
  }
  return believe(now, Verdict::good);
}

bool ImuGate::stands_still() const {
  return still_ >= stuck_samples && turns_.maxCoeff() > noisy_turns;
}

void ImuGate::forget() {
  good_.reset();
  run_.reset();
  still_ = 0;
  lately_count_ = 0;
}

bool ImuGate::frozen(const Vector6& values) {
  if (!stuck_at_) return false;
  const auto same = [&](int at) { return values.segment<3>(at) == stuck_at_->segment<3>(at); };
  if (same(0) || same(3)) return true;
  stuck_at_.reset();
  forget();
  return false;
}

bool ImuGate::goes_on(const Point& now) const {
  if (!run_ || !reachable(run_->newest, now)) return false;
  const Vector6 unit = margin();
  const auto distance = [&](const Vector6& from) {
    return (now.values - from).cwiseQuotient(unit).squaredNorm();
  };
  return distance(run_->newest.values) < distance(good_->values);
}

bool ImuGate::possible(const Vector6& values) const {
  // Each comparison is false for NaN too.
  return values.head<3>().cwiseAbs().maxCoeff() <= limits_.turn_radps &&
         std::abs(values.tail<3>().norm() - units::standard_gravity) <= limits_.acceleration_mps2;
}

ImuGate::Vector6 ImuGate::margin() const {
  Vector6 least;
  least << Eigen::Vector3d::Constant(gate::least_turn), Eigen::Vector3d::Constant(least_force);
  return (gate::noise_times * usual_).cwiseMax(least);
}

bool ImuGate::within_margin(const Vector6& leap) const {
  return (leap.cwiseAbs().array() <= margin().array()).all();
}

bool ImuGate::reachable(const Point& from, const Point& to) const {
  const double dt = seconds(to.at - from.at);
  Vector6 allowed = margin();
  allowed.head<3>().array() += limits_.turn_change_radps2 * dt;
  allowed.tail<3>().array() += limits_.force_change_mps3 * dt;
  return ((to.values - from.values).cwiseAbs().array() <= allowed.array()).all();
}

ImuGate::Verdict ImuGate::doubt(const Point& now) {
  if (goes_on(now)) {
    run_->still &= equal_where_leapt(run_->leap, margin(), run_->newest.values, now.values);
    run_->unrest += (now.values - run_->newest.values).cwiseAbs();
    run_->newest = now;
    ++run_->samples;
  } else {
    run_ = Run{.newest = now, .leap = now.values - good_->values};
  }
  if (run_->samples < gate::step_samples && seconds(now.at - good_->at) < gate::longest_doubt_s)
    return Verdict::wild;
  const bool steady = run_->samples >= gate::step_samples;
  if (steady && run_->still && still_ < still_samples) {
    stuck_at_ = now.values;
    return Verdict::wild;
  }
  // The last good sample or the first of the run alone may have been off: then nothing stepped.
  const Vector6 from_good = run_->leap, place = usual_place();
  run_->leap += good_->values - place;
  const Vector6 newest = now.values - place - run_->samples * trend_;
  const bool back = steady && (within_margin(run_->leap) || within_margin(newest));
  step_ = back ? unused(from_good) : step_of_run();
  return believe(now, Verdict::stepped);
}

// Where the last good sample would have been by the median of the last five, which is two of their
// intervals older.
ImuGate::Vector6 ImuGate::usual_place() const {
  if (lately_count_ < lately_.size()) return good_->values;
  Vector6 place;
  for (int i = 0; i < 6; ++i) {
    std::array<double, 5> values{};
    std::ranges::transform(lately_, values.begin(), [i](const Vector6& v) { return v(i); });
    std::ranges::nth_element(values, values.begin() + 2);
    place(i) = values[2] + 2 * trend_(i);
  }
  return place;
}

ImuStep ImuGate::step_of_run() const {
  ImuStep step;
  step.thawed = still_ >= still_samples && !run_->still;
  if (run_->samples < gate::step_samples) {  // the samples do not agree, so nothing is known
    step.rate_sigma = run_->leap.head<3>().norm();
    step.force_sigma = run_->leap.tail<3>().norm();
    return step;
  }
  if (step.thawed) return step;
  if (is_noise()) return unused(run_->leap);
  const Vector6 limit = margin(), steps = run_->leap - trend_;
  const Vector6 kept = (run_->leap.cwiseAbs().array() > limit.array()).select(steps, 0);
  step.rate = kept.head<3>();
  step.force = kept.tail<3>();
  if (!step.rate.isZero(0)) step.rate_sigma = per_mean_size * off_trend_.head<3>().maxCoeff();
  if (!step.force.isZero(0)) step.force_sigma = per_mean_size * off_trend_.tail<3>().maxCoeff();
  return step;
}

// The line between the last good sample and the newest stands for the run. Its turn is wrong by
// half of what the first was off from the second, if one of them was wrong.
ImuStep ImuGate::unused(const Vector6& leap) const {
  ImuStep step;
  step.turn_sigma = leap.head<3>().norm() * seconds(run_->newest.at - good_->at) / 2;
  return step;
}

// Behind a step a sensor is as quiet as before it. One that has become noisy goes on to leap.
bool ImuGate::is_noise() const {
  const Vector6 limit = margin();
  const double changes = restless_times / gate::noise_times * (run_->samples - 1);
  return ((run_->leap.cwiseAbs().array() > limit.array()) &&
          (run_->unrest.array() > changes * limit.array()))
      .any();
}

void ImuGate::learn(const Point& now) {
  if (!good_) return;
  const Vector6 change = now.values - good_->values;
  still_ = change.isZero(0) ? still_ + 1 : 0;
  if (still_ == 0) learn_noise(change);
}

void ImuGate::learn_noise(const Vector6& change) {
  const double share = std::max(gate::newest_share, 1.0 / (1 + learned_));
  Vector6 most = Vector6::Constant(std::numeric_limits<double>::infinity());
  if (learned_ >= gate::learn_samples)
    most = gate::most_usual * usual_.cwiseMax(margin() / gate::noise_times);
  usual_ += share * (change.cwiseAbs().cwiseMin(most) - usual_);
  off_trend_ += share * ((change - trend_).cwiseAbs().cwiseMin(most) - off_trend_);
  trend_ += share * (change.cwiseMin(most).cwiseMax(-most) - trend_);
  for (int i = 0; i < 6; ++i) {
    if (change(i) == 0) continue;
    turns_(i) += share * ((change(i) * change_(i) < 0 ? 1 : 0) - turns_(i));
    change_(i) = change(i);
  }
  learned_ = std::min(learned_ + 1, gate::learn_samples);
}

ImuGate::Verdict ImuGate::believe(const Point& now, Verdict verdict) {
  if (verdict == Verdict::stepped) {
    still_ = 0;
    lately_count_ = 0;
  }
  lately_[lately_count_++ % lately_.size()] = now.values;
  good_ = now;
  run_.reset();
  return verdict;
}

}  // namespace drydock::pipeline

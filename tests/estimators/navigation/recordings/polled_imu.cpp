#include "tests/estimators/navigation/recordings/polled_imu.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "tests/estimators/navigation/recordings/own_clock.hpp"

namespace drydock::navigation::test {

namespace {

constexpr std::size_t few = 20;  // fewer repeats are too few to estimate a clock
constexpr int reach = 6;         // samples on each side that fill in a lost one, all six axes
constexpr int around = 12;       // samples on each side that give its sigma
constexpr int inputs = 6 * 2 * reach;
using Samples = std::vector<OwnSample>;

/// Makes one entry for each of the IMU's own samples. A sample that no poll read is marked in
/// `lost`; it keeps its interpolated value until fill() replaces that.
void place(std::span<const Poll> polls, const std::vector<bool>& repeats, const OwnClock& clock,
           Samples& samples, std::vector<bool>& lost) {
  const long begin = clock.newest(polls[0].t);
  long last = begin;
  samples.push_back({clock.time(begin), polls[0].value});
  for (std::size_t i = 1; i < polls.size(); ++i) {
    if (repeats[i]) continue;
    const long now = std::max(last + 1, clock.newest(polls[i].t));
    const Vector6 before = samples.back().value;
    for (long j = last + 1; j <= now; ++j) {
      const double part = static_cast<double>(j - last) / static_cast<double>(now - last);
      samples.push_back({clock.time(j), before + part * (polls[i].value - before)});
    }
    last = now;
    lost.resize(samples.size() - 1, true);
    lost.resize(samples.size(), false);
  }
}

/// Eq. (R2): all axes of the neighbours, each divided by its standard deviation.
Eigen::Matrix<double, inputs, 1> neighbours(const Samples& samples, std::size_t i,
                                            const Vector6& mean, const Vector6& deviation) {
  Eigen::Matrix<double, inputs, 1> x;
  for (int k = 0; k < reach; ++k) {
    const std::size_t off = 1 + static_cast<std::size_t>(k);
    x.segment<6>(12 * k) = (samples[i - off].value - mean).cwiseQuotient(deviation);
    x.segment<6>(12 * k + 6) = (samples[i + off].value - mean).cwiseQuotient(deviation);
  }
  return x;
}

/// Eq. (R2), (R3). False if there are too few complete stretches to learn from.
bool fill(Samples& samples, const std::vector<bool>& lost) {
  const auto size = samples.size();
  const std::size_t edge = reach;
  Vector6 mean = Vector6::Zero(), square = Vector6::Zero();
  for (const OwnSample& s : samples) mean += s.value / static_cast<double>(size);
  for (const OwnSample& s : samples)
    square += (s.value - mean).cwiseAbs2() / static_cast<double>(size);
  const Vector6 deviation = square.cwiseSqrt().cwiseMax(1e-9);

  Eigen::Matrix<double, inputs, inputs> normal = Eigen::Matrix<double, inputs, inputs>::Zero();
  Eigen::Matrix<double, inputs, 6> right = Eigen::Matrix<double, inputs, 6>::Zero();
  std::size_t whole = 0, since_lost = 0;
  for (std::size_t i = 0; i < size; ++i) {
    since_lost = lost[i] ? 0 : since_lost + 1;
    if (since_lost < 2 * edge + 1) continue;
    const auto x = neighbours(samples, i - edge, mean, deviation);
    normal.selfadjointView<Eigen::Lower>().rankUpdate(x);
    right += x * (samples[i - edge].value - mean).transpose();
    ++whole;
  }
  if (whole < 10 * inputs) return false;
  normal.diagonal().array() += 1e-6 * normal.trace() / inputs;
  const Eigen::Matrix<double, inputs, 6> weights =
      normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);

  const auto predicted = [&](std::size_t i) -> Vector6 {
    return mean + weights.transpose() * neighbours(samples, i, mean, deviation);
  };
  Samples filled = samples;
  for (std::size_t i = edge; i + edge < size; ++i)
    if (lost[i]) filled[i].value = predicted(i);
  samples.swap(filled);
  for (std::size_t i = edge + around; i + edge + around < size; ++i) {
    if (!lost[i]) continue;
    Vector6 sum = Vector6::Zero();
    int n = 0;
    for (std::size_t k = i - around; k <= i + around; ++k)
      if (!lost[k]) sum += (samples[k].value - predicted(k)).cwiseAbs2(), ++n;
    samples[i].missed = (sum / n).cwiseSqrt();
  }
  return true;
}

}  // namespace

Read<OwnSamples> own_samples(std::span<const Poll> polls) {
  const std::vector<bool> repeats = repeats_of(polls);
  const auto repeated = static_cast<std::size_t>(std::count(repeats.begin(), repeats.end(), true));
  OwnSamples own{{}, 0, repeated, 0};
  if (repeated < few) {
    for (const Poll& poll : polls) own.samples.push_back({poll.t, poll.value});
    return own;
  }
  const auto clock = own_clock(polls, repeats);
  if (clock.has_error()) return clock.error();
  own.period_s = clock->period;
  std::vector<bool> lost(1, false);
  place(polls, repeats, *clock, own.samples, lost);
  own.lost = static_cast<std::size_t>(std::count(lost.begin(), lost.end(), true));
  if (own.lost > 0 && !fill(own.samples, lost))
    return Refusal{"IMU", "too few whole stretches to fill lost samples from"};
  return own;
}

}  // namespace drydock::navigation::test

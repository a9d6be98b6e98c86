#include "tests/estimators/navigation/recordings/own_clock.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace drydock::navigation::test {

namespace {

constexpr double furthest = 0.03, nearest = 5e-4;  // relative difference of the two rates
constexpr double coarse_s = 100;     // length of the first line, which guides the rest
constexpr std::size_t window = 500;  // polls for one point of the stray
constexpr double fine_s = 5e-5;      // step between the strays that are tried
constexpr int tried = 30;            // number of steps, early and late

/// Eq. (R1): after a repeat, the next sample came between the repeat and one period after the poll
/// before.
struct Repeat {
  double poll, before;
  double arrival(double period) const { return (poll + before + period) / 2; }
};

/// The period for which the phases of the arrivals agree best, by the length of their resultant.
double coarse_period(const std::vector<Repeat>& repeats, double polled, bool faster) {
  const double span = std::min(coarse_s, repeats.back().poll - repeats.front().poll);
  const double step = polled * polled / span / 10;
  double best = 0, found = polled;
  const int last = static_cast<int>(furthest * polled / step);
  for (int i = static_cast<int>(nearest * polled / step); i < last; ++i) {
    const double off = i * step;
    const double period = faster ? polled - off : polled + off;
    std::complex<double> sum = 0;
    for (const Repeat& r : repeats) {
      if (r.poll - repeats.front().poll > coarse_s) break;
      sum += std::polar(1.0,
                        2 * std::numbers::pi * (r.arrival(period) - repeats.front().poll) / period);
    }
    if (std::abs(sum) > best) best = std::abs(sum), found = period;
  }
  return found;
}

OwnClock line_near(const std::vector<Repeat>& repeats, double period) {
  OwnClock clock{repeats.front().arrival(period), period, {}, {}};
  for (const double reach : {coarse_s, repeats.back().poll}) {
    double n = 0, j1 = 0, j2 = 0, e1 = 0, je = 0;
    double led = 0;  // the stray so far, so that no sample is miscounted
    for (const Repeat& r : repeats) {
      if (r.poll - repeats.front().poll > reach) break;
      const double arrival = r.arrival(clock.period);
      const double j = std::round((arrival - clock.first - led) / clock.period);
      const double e = arrival - clock.first - j * clock.period;
      led += (e - led) / 10;
      n += 1, j1 += j, j2 += j * j, e1 += e, je += j * e;
    }
    const double slope = (n * je - j1 * e1) / (n * j2 - j1 * j1);
    clock.first += (e1 - slope * j1) / n;
    clock.period += slope;
  }
  return clock;
}

/// Number of polls in a window where a clock that is `stray` s late disagrees with `repeats`.
int unexplained(std::span<const Poll> polls, const std::vector<bool>& repeats, std::size_t from,
                const OwnClock& clock, double stray) {
  int count = 0;
  const auto newest = [&](std::size_t i) {
    return std::floor((polls[i].t - clock.first - stray) / clock.period);
  };
  double before = newest(from);
  for (std::size_t i = from + 1; i < std::min(polls.size(), from + window); ++i) {
    const double now = newest(i);
    count += (now == before) != repeats[i];
    before = now;
  }
  return count;
}

/// The stray for each window: the mean of those strays with the fewest unexplained polls.
void add_stray(std::span<const Poll> polls, const std::vector<bool>& repeats, OwnClock& clock) {
  for (std::size_t from = 0; from == 0 || from + window <= polls.size(); from += window / 2) {
    int fewest = static_cast<int>(window);
    double sum = 0;
    int n = 0;
    for (int i = -tried; i <= tried; ++i) {
      const double stray = i * fine_s;
      const int count = unexplained(polls, repeats, from, clock, stray);
      if (count < fewest) fewest = count, sum = 0, n = 0;
      if (count == fewest) sum += stray, ++n;
    }
    clock.stray_at.push_back(polls[std::min(polls.size() - 1, from + window / 2)].t);
    clock.stray.push_back(sum / n);
  }
}

}  // namespace

double OwnClock::stray_near(double t) const {
  const auto after = std::upper_bound(stray_at.begin(), stray_at.end(), t);
  if (after == stray_at.begin()) return stray.front();
  if (after == stray_at.end()) return stray.back();
  const auto i = static_cast<std::size_t>(after - stray_at.begin());
  const double part = (t - stray_at[i - 1]) / (stray_at[i] - stray_at[i - 1]);
  return stray[i - 1] + part * (stray[i] - stray[i - 1]);
}

long OwnClock::newest(double t) const {
  return static_cast<long>(std::floor((t - first - stray_near(t)) / period));
}

std::vector<bool> repeats_of(std::span<const Poll> polls) {
  std::vector<bool> repeats(polls.size(), false);
  for (std::size_t i = 1; i < polls.size(); ++i) repeats[i] = polls[i].value == polls[i - 1].value;
  return repeats;
}

Read<OwnClock> own_clock(std::span<const Poll> polls, const std::vector<bool>& repeats) {
  std::vector<Repeat> found;
  for (std::size_t i = 1; i < polls.size(); ++i)
    if (repeats[i]) found.push_back({polls[i].t, polls[i - 1].t});
  const double polled = (polls.back().t - polls.front().t) / static_cast<double>(polls.size() - 1);
  OwnClock best;
  std::size_t fewest = found.size() / 10 + 1;
  for (const bool faster : {true, false}) {
    OwnClock clock = line_near(found, coarse_period(found, polled, faster));
    add_stray(polls, repeats, clock);
    std::size_t wrong = 0;
    for (std::size_t i = 1; i < polls.size(); ++i)
      wrong += (clock.newest(polls[i].t) == clock.newest(polls[i - 1].t)) != repeats[i];
    if (wrong < fewest) fewest = wrong, best = clock;
  }
  if (best.period == 0) return Refusal{"IMU", "repeated rows that no steady clock explains"};
  return best;
}

}  // namespace drydock::navigation::test

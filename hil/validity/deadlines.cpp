#include "hil/validity/deadlines.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::validity {
namespace {

std::int64_t second_of(Stamp at) {
  return std::chrono::floor<std::chrono::seconds>(at.time_since_epoch()).count();
}

double microseconds_of(Stamp::duration d) { return static_cast<double>(d.count()) / 1e3; }

/// For each sample: when the last measurement from it was out.
std::map<Stamp, Stamp> answers(std::span<const Figures> figures) {
  std::map<Stamp, Stamp> out_at;
  for (const Figures& of : figures)
    for (std::size_t i = 0; i < of.sampled_at.size(); ++i) {
      Stamp& last = out_at[of.sampled_at[i]];
      last = std::max(last, of.out_at[i]);
    }
  return out_at;
}

}  // namespace

void Floor::add(Stamp seen, double us, double Worst::*which) {
  const auto began = seen - std::chrono::nanoseconds{static_cast<std::int64_t>(us * 1e3)};
  for (auto second = second_of(began); second <= second_of(seen); ++second) {
    double& worst = seconds_[second].*which;
    worst = std::max(worst, us);
  }
}

double Floor::worst_us(Stamp from, Stamp to) const {
  double worst = 0;
  for (auto it = seconds_.lower_bound(second_of(from));
       it != seconds_.end() && it->first <= second_of(to); ++it)
    worst = std::max(worst, it->second.timer_us + it->second.link_us);
  return worst;
}

bool Deadlines::rate_held() const {
  return std::abs(sent_hz - asked_hz) * judged_s <= 1 + 1e-6 * asked_hz * judged_s;
}

Deadlines deadlines_of(std::string device, double rate_hz, std::span<const Stamp> sent,
                       std::span<const Figures> figures, const Floor& floor, Period run) {
  Deadlines d;
  d.device = std::move(device);
  d.asked_hz = rate_hz;
  const auto out_at = answers(figures);
  if (out_at.empty()) return d;
  const Stamp first = out_at.begin()->first;
  d.first_s = measurement::seconds(out_at.begin()->second - run.begin);
  d.judged_s = measurement::seconds(run.end - first);

  const double period_us = 1e6 / rate_hz;
  const auto period = measurement::from_seconds(1 / rate_hz);
  std::vector<double> responses_us;
  d.least_margin_us = period_us;
  std::size_t left = 0;
  for (const Stamp sample : sent) {
    if (sample < first || sample > run.end) continue;
    ++left;
    const auto answer = out_at.find(sample);
    const Stamp until = answer == out_at.end() ? sample + period : answer->second;
    const double allowed_us = period_us + floor.worst_us(sample, until);
    if (answer == out_at.end()) {
      const bool was_due = microseconds_of(run.end - sample) > allowed_us;
      const bool stalled = allowed_us > 2 * period_us;
      d.stalled += was_due && stalled;
      d.lost += was_due && !stalled;
      d.samples += was_due && !stalled;
      continue;
    }
    ++d.samples;
    responses_us.push_back(microseconds_of(answer->second - sample));
    const double margin_us = allowed_us - responses_us.back();
    d.missed += margin_us < 0;
    d.least_margin_us = std::min(d.least_margin_us, margin_us);
  }
  d.sent_hz = static_cast<double>(left) / d.judged_s;
  d.response = spread_of(std::move(responses_us));
  return d;
}

}  // namespace drydock::validity

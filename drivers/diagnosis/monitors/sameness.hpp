#pragma once

#include <algorithm>
#include <cmath>

#include "drivers/diagnosis/monitors/quantity.hpp"

namespace drydock::diagnosis {

using measurement::Stamp;

/// How often a message has exactly the values of the one before. Where noise shows, a long run of
/// equal messages is impossible: with the share q of equal ones in the sensor's own first time, n
/// in a row have the probability q^n.
class Sameness {
 public:
  static constexpr std::chrono::seconds learning{45};
  static constexpr double false_alarm = 1e-10;  ///< probability of a run in healthy messages

  /// True if the values are those of the message before.
  bool add(const Readings& readings, Stamp at) {
    const bool same = !readings.empty() && equal(readings);
    if (!first_) first_ = at;
    run_ = same ? run_ + 1 : 0;
    if (!same) before_ = last_;
    if (run_ == 1) run_since_ = at;
    last_ = readings;
    if (!learned_) learn(same, at);
    return same;
  }
  void interrupt() { run_ = 0; }

  unsigned run() const { return run_; }
  Stamp run_since() const { return run_since_; }
  const Readings& before_run() const { return before_; }
  const Readings& latest() const { return last_; }

  /// A run of so many is impossible. Empty: equal messages are usual here, or not learned yet.
  std::optional<unsigned> impossible_run() const { return impossible_run_; }

 private:
  bool equal(const Readings& readings) const {
    return std::ranges::equal(readings, last_, [](const Reading& a, const Reading& b) {
      return a.quantity == b.quantity && a.value == b.value;
    });
  }

  /// The largest share of the windows counts: a sensor without noise that toggles between two
  /// numbers in a turn stands still on a straight leg.
  void learn(bool same, Stamp at) {
    ++count_;
    same_ += same ? 1 : 0;
    longest_ = std::max(longest_, run_);
    if (count_ >= window) {
      share_ = std::max(share_, (same_ + 1.0) / (count_ + 1.0));
      ++windows_;
      count_ = 0;
      same_ = 0;
    }
    learned_ = at - *first_ >= learning && windows_ > 0;
    if (learned_) settle();
  }

  void settle() {
    constexpr double most_share = 0.7;
    if (share_ > most_share) return;
    const double run = std::ceil(std::log(false_alarm) / std::log(share_));
    impossible_run_ = std::max({static_cast<unsigned>(run), 4U, 2 * longest_ + 2});
  }

  static constexpr unsigned window = 30;  ///< messages
  Readings last_, before_;
  std::optional<Stamp> first_;
  bool learned_ = false;
  std::optional<unsigned> impossible_run_;
  unsigned run_ = 0, longest_ = 0, count_ = 0;
  unsigned windows_ = 0;
  double same_ = 0, share_ = 0;
  Stamp run_since_{};
};

}  // namespace drydock::diagnosis

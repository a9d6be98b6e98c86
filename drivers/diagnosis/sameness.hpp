#pragma once

#include <algorithm>
#include <cmath>

#include "drivers/diagnosis/quantity.hpp"

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
    if (at - *first_ < learning) {
      ++count_;
      same_ += same ? 1 : 0;
      longest_ = std::max(longest_, run_);
    }
    learned_ = at - *first_ >= learning;
    return same;
  }
  void interrupt() { run_ = 0; }

  unsigned run() const { return run_; }
  Stamp run_since() const { return run_since_; }
  const Readings& before_run() const { return before_; }
  const Readings& latest() const { return last_; }

  /// A run of so many is impossible. Empty: equal messages are usual here, or not learned yet.
  std::optional<unsigned> impossible_run() const {
    constexpr unsigned fewest = 30;
    constexpr double most_share = 0.7;
    if (!learned_ || count_ < fewest) return {};
    const double share = (same_ + 1.0) / (count_ + 1.0);
    if (share > most_share) return {};
    const double run = std::ceil(std::log(false_alarm) / std::log(share));
    return std::max({static_cast<unsigned>(run), 4U, 2 * longest_ + 2});
  }

 private:
  bool equal(const Readings& readings) const {
    return std::ranges::equal(readings, last_, [](const Reading& a, const Reading& b) {
      return a.quantity == b.quantity && a.value == b.value;
    });
  }

  Readings last_, before_;
  std::optional<Stamp> first_;
  bool learned_ = false;
  unsigned run_ = 0, longest_ = 0, count_ = 0;
  double same_ = 0;
  Stamp run_since_{};
};

}  // namespace drydock::diagnosis

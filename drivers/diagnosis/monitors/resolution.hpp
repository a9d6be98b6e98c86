#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::diagnosis {

using measurement::Stamp;

/// The step in which a sensor's numbers come. A changed range, output format or gateway makes it
/// coarser, and nothing else shows that. All differences are whole steps, so the step is their
/// greatest common divisor: in the sensor's own first time, then in each `window`. Second
/// differences, because a steady turn without noise makes all first ones equal.
class Resolution {
 public:
  static constexpr std::chrono::seconds learning{45};
  static constexpr unsigned fewest = 60, window = 40;  ///< differences
  static constexpr std::int64_t coarser = 4;           ///< times, to be told

  /// `bend`: a second difference. The new step while all are whole ones of it; what divides by
  /// four by chance does so forty times in a row with 1e-24.
  std::optional<double> add(double bend, Stamp at) {
    bend = std::abs(bend);
    if (!first_) first_ = at;
    if (bend > 0) state_ == State::known ? judge(bend, at) : learn(bend, at);
    if (in_window_ < window) return {};
    return static_cast<double>(common_) * step_;
  }

  bool known() const { return state_ == State::known; }
  double step() const { return step_; }  ///< of the first time
  Stamp since() const { return since_; }

 private:
  enum class State : std::uint8_t { learns, known, has_none };

  /// Euclid's algorithm for numbers that are whole but for rounding.
  void learn(double bend, Stamp at) {
    constexpr double rounding = 1e-6, continuous = 1e-3;  // of the largest bend
    if (state_ == State::has_none) return;
    largest_ = std::max(largest_, bend);
    double divisor = step_, rest = bend;
    while (rest > rounding * largest_) {
      const double left = std::abs(std::remainder(divisor, rest));
      divisor = rest;
      rest = left;
    }
    step_ = divisor;
    if (step_ < continuous * largest_)
      state_ = State::has_none;
    else if (++bends_ >= fewest && at - *first_ >= learning)
      state_ = State::known;
  }

  void judge(double bend, Stamp at) {
    constexpr double near = 0.1, most = 1e15;
    const double steps = bend / step_;
    const bool whole = steps < most && std::abs(steps - std::round(steps)) < near;
    if (in_window_ == 0) since_ = at;
    common_ = whole ? std::gcd(common_, std::llround(steps)) : 1;
    in_window_ = common_ < coarser ? 0 : std::min(in_window_ + 1, window);
    if (in_window_ == 0) common_ = 0;
  }

  State state_ = State::learns;
  std::optional<Stamp> first_;
  double step_ = 0, largest_ = 0;
  unsigned bends_ = 0;
  // of the window
  std::int64_t common_ = 0;  ///< divisor of the bends, in steps
  unsigned in_window_ = 0;
  Stamp since_{};
};

}  // namespace drydock::diagnosis

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drydock::diagnosis {

/// A sensor that gives a fraction of its samples, one in 1.74, takes every first or second one in
/// turn: its intervals are whole periods that follow a line, S_k = floor(k r + phase). Messages
/// that are lost at random do not. There are about n^3 / pi^2 sequences of n intervals that follow
/// any line (Mignosi, Theor. Comput. Sci. 82, 1991), and a loss of the same share makes one of them
/// with the probability q^n (1 - q)^(S - n), q = n / S, of S periods.
class ThinnedRate {
 public:
  /// An interval of so many periods.
  void add(long periods) {
    std::rotate(intervals_.begin(), intervals_.begin() + 1, intervals_.end());
    intervals_.back() = static_cast<double>(periods);
    known_ = std::min(known_ + 1, intervals_.size());
  }
  void clear() { known_ = 0; }

  /// How many times slower it is. 1: the intervals may be a random loss.
  double times() const {
    double least = 0, most = std::numeric_limits<double>::infinity(), sum = 0;
    std::array<double, longest + 1> sums{};
    std::size_t n = 0;
    while (n < known_) {
      const double next = sum + intervals_[intervals_.size() - 1 - n];
      double lower = least, upper = most;
      for (std::size_t i = 0; i <= n; ++i) {
        const auto steps = static_cast<double>(n + 1 - i);
        lower = std::max(lower, (next - sums[i] - 1) / steps);
        upper = std::min(upper, (next - sums[i] + 1) / steps);
      }
      if (lower >= upper) break;
      least = lower, most = upper;
      sums[++n] = sum = next;
    }
    return is_no_chance(static_cast<double>(n), sum) ? sum / static_cast<double>(n) : 1;
  }

 private:
  static constexpr std::size_t longest = 32;
  /// A random loss looks so once in 1000 windows.
  static constexpr double certain = 7;
  static constexpr double fewest = 6;

  static bool is_no_chance(double n, double periods) {
    if (n < fewest || periods <= n) return false;
    const double kept = n / periods;
    const double log_loss = n * std::log(kept) + (periods - n) * std::log(1 - kept);
    constexpr double pi_square = 9.8696;
    return -log_loss - std::log(n * n * n / pi_square) > certain;
  }

  std::array<double, longest> intervals_{};  ///< the latest last
  std::size_t known_ = 0;
};

}  // namespace drydock::diagnosis

#pragma once

#include <algorithm>
#include <cmath>

namespace drydock::consistency {

/// Page's cumulative sum of standardised residuals, for a shift up and one for a shift down. The
/// reference value is half the shift that it finds fastest; both are in sigmas.
struct CusumDesign {
  double reference = 1;  ///< k
  double limit = 12;     ///< h
};

/// Siegmund 1985, (2.57) with the overshoot 1.166: the mean number of samples until one of two
/// sides passes the limit, for Gaussian residuals whose mean is `shift` sigmas. It is the mean time
/// between false alarms for shift 0.
inline double mean_samples_to_alarm(const CusumDesign& design, double shift = 0) {
  constexpr double overshoot = 1.166;
  const double b = design.limit + overshoot;
  const auto one_side = [&](double drift) {
    if (std::abs(drift) < 1e-9) return b * b;
    return (std::exp(-2 * drift * b) + 2 * drift * b - 1) / (2 * drift * drift);
  };
  return 1 / (1 / one_side(shift - design.reference) + 1 / one_side(-shift - design.reference));
}

/// The two sums.
class Cusum {
 public:
  /// The largest step of a sum. One wild residual alone never passes the limit.
  static constexpr double longest_step = 4;

  /// `z`: residual over its sigma. The sums stay below 1.25 limits, so that they come back soon.
  void take(double z, const CusumDesign& design) {
    const auto next = [&](double sum, double value) {
      return std::clamp(sum + std::min(value - design.reference, longest_step), 0.0,
                        1.25 * design.limit);
    };
    up_ = next(up_, z);
    down_ = next(down_, -z);
  }

  double value() const { return std::max(up_, down_); }
  bool is_up() const { return up_ >= down_; }  ///< what it found lies above
  void clear() { up_ = down_ = 0; }

 private:
  double up_ = 0, down_ = 0;
};

}  // namespace drydock::consistency

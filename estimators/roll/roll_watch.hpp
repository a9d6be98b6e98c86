#pragma once

#include <array>

namespace drydock::roll {

/// What the signals of one epoch say against the roll of a filter: the slope of their log
/// likelihood, 1/rad, and the variance of this slope if the filter is right, 1/rad2.
struct Evidence {
  double score = 0, information = 0;
};

/// Judges the evidence of the last seconds, eq. (37) of docs/estimators/roll.md: that of one epoch
/// is too little to see a wrong roll. Allocates nothing.
class RollWatch {
 public:
  /// Of a standard normal value: two-sided 6e-5. A sound filter is contradicted about twice an
  /// hour.
  static constexpr double limit = 4;

  /// `dt_s`: since the epoch before.
  void add(const Evidence& epoch, double dt_s);
  void clear() { *this = {}; }

  /// Standard normal if the filter is right: of the window that says most against it.
  double statistic() const;
  bool contradicts() const { return !(statistic() <= limit && statistic() >= -limit); }
  /// Variance of an error that the signals suspect and do not contradict yet, rad2: eq. (38). 0 for
  /// all but 1.2 % of the time of a right filter, for each window.
  double suspected_variance() const;
  /// By how much the roll would have to be more for this window to say nothing, rad.
  double error_rad() const;

 private:
  struct Window {
    double span_s;
    double score = 0, information = 0, variance = 0;
    double statistic() const;
    double error_rad() const { return information > 0 ? score / information : 0; }
  };
  const Window& loudest() const;

  std::array<Window, 4> windows_{{{0.6}, {2}, {6}, {18}}};
};

}  // namespace drydock::roll

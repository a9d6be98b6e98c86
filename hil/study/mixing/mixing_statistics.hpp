#pragma once

#include <array>

#include "hil/study/ensemble.hpp"
#include "hil/study/mixing/mixing_trial.hpp"

namespace drydock::study {

/// One variant over all runs, in degrees.
struct MixingStatistics {
  Ensemble roll{mixing_points}, pitch{mixing_points};
  double nees_sum = 0;

  void add(const MixingOutcome& outcome);
  double nees_mean() const { return nees_sum / static_cast<double>(roll.runs()); }

  /// Standard deviation over the runs, averaged over the cruise from 300 s to 560 s.
  static double cruise_deviation(const Ensemble& error);
  /// Largest absolute value of the mean over the runs, between `from_s` and `to_s`.
  static double mean_peak(const Ensemble& error, double from_s = 0,
                          double to_s = mixing_duration_s);
  double largest_deviation() const;  ///< both angles, at any time
  double acceleration_peak() const { return mean_peak(pitch, 135, 165); }
};

using MixingResults = std::array<MixingStatistics, mixing_variants.size()>;

}  // namespace drydock::study

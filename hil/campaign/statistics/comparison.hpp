#pragma once

#include <optional>
#include <span>

namespace drydock::campaign {

/// What became of a figure since an earlier campaign.
struct Shift {
  std::optional<double> low{}, high{};  ///< bounds of the median difference at the confidence
  double median = 0;                    ///< of later minus earlier
};

/// Differences of runs with equal values and seed: the median with its bounds from order
/// statistics, whatever the distribution. At least one pair.
Shift paired_shift(std::span<const double> earlier, std::span<const double> later,
                   double confidence);

/// For other runs: the median of all differences of a later and an earlier value, with the bounds
/// that belong to the rank test of Mann and Whitney (Hodges and Lehmann; normal approximation,
/// from about ten values a side). At most 1000 values a side count, evenly taken.
Shift unpaired_shift(std::span<const double> earlier, std::span<const double> later,
                     double confidence);

}  // namespace drydock::campaign

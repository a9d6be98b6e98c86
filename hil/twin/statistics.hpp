#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hil/characterize/quantity.hpp"
#include "hil/twin/errors.hpp"

namespace drydock::twin {

/// A time between two samples.
struct Gap {
  measurement::Stamp from{}, to{};
};

/// When a device's samples came. A step of more than 1.5 times the median one is an outage.
struct Timing {
  std::uint64_t samples = 0;
  double rate_hz = 0;                   ///< one over the median step; 0: fewer than two samples
  std::uint64_t outages = 0, lost = 0;  ///< lost samples, as whole median steps
  double longest_gap_s = 0;
  std::vector<Gap> long_gaps;  ///< outages of five steps or more, at most the first 100
  std::uint64_t lost_in_long_gaps = 0;
};

Timing timing_of(std::span<const Error> errors);

/// The errors of one axis, SI. Their noise is white noise of each sample and a first-order
/// Gauss-Markov process.
struct AxisNoise {
  std::uint64_t values = 0;
  double mean = 0, sigma = 0;
  double white = 0, slow = 0, correlation_s = 0;  ///< slow 0: none is seen
};

/// White noise from fourth differences, which take out what is a cubic over five samples: so motion
/// that the track does not have hardly counts. The rest is slow noise where neighbours agree more
/// than chance lets them; it lasts as long as their autocovariance. A track follows its sensors'
/// slow noise, so what is seen of it is a lower bound. Empty: fewer than ten values.
std::optional<AxisNoise> noise_of(std::span<const double> values, double step_s);

struct QuantityNoise {
  characterize::Quantity quantity;
  std::array<std::optional<AxisNoise>, 3> axes;
};

struct DeviceStatistics {
  Timing timing;
  std::uint64_t empty = 0;      ///< samples without the primary quantity: no bottom lock, no fix
  std::vector<Gap> empty_runs;  ///< three such samples or more, at most the first 100
  std::vector<QuantityNoise> quantities;
};

DeviceStatistics statistics_of(std::span<const Error> errors, rig_config::DeviceKind kind);

}  // namespace drydock::twin

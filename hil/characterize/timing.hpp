#pragma once

#include <chrono>
#include <optional>
#include <span>

#include "drivers/measurement/measurement.hpp"
#include "hil/characterize/estimate.hpp"

namespace drydock::characterize {

/// The arrival times of a device's samples.
struct TimingFigures {
  std::size_t samples = 0;
  Estimate rate_hz;                           ///< by the host's clock, from all arrivals
  std::optional<Estimate> device_rate_hz;     ///< by the device's own clock
  double jitter_s = 0, largest_jitter_s = 0;  ///< arrivals relative to the regular grid: rms,
                                              ///< extreme
  double latency_s = 0, latency_spread_s = 0, largest_latency_s = 0;  ///< received_at - valid_at

  // A gap of more than 1.5 periods is an outage, one of more than 100 a pause, which is none.
  std::size_t outages = 0, lost = 0;
  std::size_t pauses = 0;
  double paused_s = 0;
  Estimate outage_probability;  ///< per sample that arrived
  double mean_outage = 0;       ///< samples; 0: no outage
};

/// Fits a line of arrival times over sample numbers by least squares. A lost sample keeps its
/// number; behind a pause the line begins anew, with the same slope. Empty if there are fewer than
/// ten samples, or all have the same time.
std::optional<TimingFigures> timing_of(std::span<const measurement::Origin> origins);

}  // namespace drydock::characterize

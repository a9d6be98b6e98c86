#pragma once

#include <chrono>
#include <optional>
#include <span>

#include "drivers/measurement/measurement.hpp"
#include "hil/characterize/estimate.hpp"

namespace drydock::characterize {

/// When the samples of a device came.
struct TimingFigures {
  std::size_t samples = 0;
  Estimate rate_hz;                           ///< by the host's clock, from all arrivals together
  std::optional<Estimate> device_rate_hz;     ///< by the device's own clock
  double jitter_s = 0, largest_jitter_s = 0;  ///< arrivals about the regular grid: rms, extreme
  double latency_s = 0, latency_spread_s = 0, largest_latency_s = 0;  ///< received_at - valid_at

  // Arrivals more than 1.5 periods apart.
  std::size_t outages = 0, lost = 0;
  Estimate outage_probability;  ///< at each sample that arrived
  double mean_outage = 0;       ///< samples; 0: there was none
};

/// Line of arrivals over sample numbers by least squares; a number is missing where a sample is.
/// Empty: fewer than ten samples, or all at one time.
std::optional<TimingFigures> timing_of(std::span<const measurement::Origin> origins);

}  // namespace drydock::characterize

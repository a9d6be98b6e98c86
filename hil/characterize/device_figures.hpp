#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hil/characterize/compare/comparison.hpp"
#include "hil/characterize/noise/noise_fit.hpp"
#include "hil/characterize/noise/steadiness.hpp"
#include "hil/characterize/quantity.hpp"
#include "hil/characterize/samples.hpp"
#include "hil/characterize/timing.hpp"

namespace drydock::characterize {

/// The figures of one axis of a quantity. SI, in the sensor's axes.
struct AxisFigures {
  std::size_t readings = 0;
  Estimate mean;               ///< bounds from the fitted noise; without a fit only the value
  std::optional<double> step;  ///< quantisation step
  AllanCurve curve;
  std::optional<NoiseFit> noise;
  Steadiness steadiness;
};

struct QuantityFigures {
  Quantity quantity;
  std::vector<std::optional<AxisFigures>> axes;  ///< three; empty: the device does not give this
                                                 ///< axis
  bool steady() const;
};

struct AgainstReference {
  std::string reference;     ///< name of the device
  int place = 0, axis = -1;  ///< the compared quantity; axis -1: none
  Comparison comparison;
};

/// The measured properties of one device.
struct DeviceFigures {
  Subject subject;
  TimingFigures timing;
  std::vector<QuantityFigures> quantities;
  std::vector<AgainstReference> against;
  std::optional<double> utc_latency_s;  ///< GNSS: mean of arrival time minus stated time
  std::optional<measurement::SoundSpeedUsed::Means> sound_speed;  ///< DVL that tells its water
};

/// Lost samples are ignored: the readings before and after a gap count as neighbours. Empty if
/// there are too few samples for a rate. Samples without times give steps and means alone.
std::optional<DeviceFigures> figures_of(const Samples& samples);

/// Compares devices of the same kind axis by axis; DVL and EM log with GNSS and with each other; an
/// IMU's turn about its z axis with a GNSS course. Only quantities that both devices give, while
/// they move. `inertial` (may be null) gives the vehicle's rotation, for the effect of lever arms.
std::vector<AgainstReference> against(const Samples& sensor, const Samples& reference,
                                      const Samples* inertial);

}  // namespace drydock::characterize

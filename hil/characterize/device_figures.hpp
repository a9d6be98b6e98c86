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

/// One axis of a quantity. SI, in the sensor's axes.
struct AxisFigures {
  std::size_t readings = 0;
  Estimate mean;               ///< bounds by the fitted noise; value alone where there is no fit
  std::optional<double> step;  ///< quantisation
  AllanCurve curve;
  std::optional<NoiseFit> noise;
  Steadiness steadiness;
};

struct QuantityFigures {
  Quantity quantity;
  std::vector<std::optional<AxisFigures>> axes;  ///< three; empty: the device does not give it
  bool steady() const;
};

struct AgainstReference {
  std::string reference;     ///< device
  int place = 0, axis = -1;  ///< of the quantity that was compared; -1: no axis of its own
  Comparison comparison;
};

/// What one device is worth.
struct DeviceFigures {
  Subject subject;
  TimingFigures timing;
  std::vector<QuantityFigures> quantities;
  std::vector<AgainstReference> against;
  std::optional<double> utc_latency_s;  ///< GNSS: mean of arrival less stated time
};

/// Lost samples are left out: readings on either side of a gap count as neighbours. Empty: too few
/// samples for a rate.
std::optional<DeviceFigures> figures_of(const Samples& samples);

/// Same kind against same kind, axis by axis; DVL and EM log against GNSS and each other; an
/// IMU's turn about its z axis against a GNSS course. Only what both devices give, and moving.
/// `inertial` (may be null) tells how the vehicle turns, so that lever arms can be taken into
/// account.
std::vector<AgainstReference> against(const Samples& sensor, const Samples& reference,
                                      const Samples* inertial);

}  // namespace drydock::characterize

#include "hil/characterize/grade/grade.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "estimators/frame/earth.hpp"

namespace drydock::characterize {
namespace {

using rig_config::Axes;
using rig_config::EmulateConfig;
using rig_config::SensorErrors;

/// One figure of one axis with its bounds.
class Place {
 public:
  Place(MeasuredGrade& grade, SensorErrors EmulateConfig::*quantity, std::size_t axis)
      : grade_(grade), quantity_(quantity), axis_(axis) {}

  void put(Axes SensorErrors::*part, const Estimate& figure) const {
    (grade_.value.*quantity_.*part)[axis_] = figure.value;
    (grade_.low.*quantity_.*part)[axis_] = figure.low;
    (grade_.high.*quantity_.*part)[axis_] = figure.high;
  }

 private:
  MeasuredGrade& grade_;
  SensorErrors EmulateConfig::*quantity_;
  std::size_t axis_;
};

Estimate scaled(const Estimate& e, double factor) {
  return {e.value * factor, e.low * factor, e.high * factor};
}

/// The file states the step separately, and the step adds q^2 / 12 to each sample. So this part is
/// removed from the noise, (8). If the noise is finer than half a step, rounding is not such noise
/// and nothing is removed.
Estimate without_step(const Estimate& density, std::optional<double> step, double rate_hz) {
  if (!step) return density;
  const double variance = density.value * density.value * rate_hz, of_step = *step * *step / 12;
  if (variance < *step * *step / 4) return density;
  return scaled(density, std::sqrt(1 - of_step / variance));
}

void put_noise(const Place& place, const AxisFigures& axis, const Quantity& quantity,
               double rate_hz) {
  if (axis.noise->density) {
    const auto density = without_step(*axis.noise->density, axis.step, rate_hz);
    if (quantity.by_density) {
      place.put(&SensorErrors::noise_density, density);
    } else {
      place.put(&SensorErrors::noise, scaled(density, std::sqrt(rate_hz)));
    }
  }
  if (axis.noise->instability) place.put(&SensorErrors::bias_instability, *axis.noise->instability);
  if (axis.noise->walk) place.put(&SensorErrors::random_walk, *axis.noise->walk);
}

/// If a sensor carries its rounding remainder, only the Allan deviation shows its step: at rest,
/// for the turns of a vehicle have the same slope there.
void put_step(const Place& place, const AxisFigures& axis, bool at_rest, double rate_hz,
              SensorErrors& errors) {
  const double of_step = std::sqrt(12.0) * rate_hz;  // Q = q dt / sqrt(12)
  if (at_rest && axis.noise && axis.noise->quantisation) {
    place.put(&SensorErrors::quantisation, scaled(*axis.noise->quantisation, of_step));
    errors.quantisation_carried = true;
  } else if (axis.step) {
    place.put(&SensorErrors::quantisation, {*axis.step, *axis.step, *axis.step});
  }
}

/// One correlation time for all axes: their geometric mean.
double correlation_of(const QuantityFigures& quantity) {
  double sum = 0;
  int axes = 0;
  for (const auto& axis : quantity.axes) {
    if (!axis || !axis->noise || !axis->noise->correlation_s) continue;
    sum += std::log(axis->noise->correlation_s->value);
    ++axes;
  }
  return axes > 0 ? std::exp(sum / axes) : SensorErrors{}.correlation_s;
}

void put_bias_at_rest(const Place& place, const AxisFigures& axis) {
  if (std::abs(axis.mean.value) <= frame::wgs84::earth_rate_radps) return;
  place.put(&SensorErrors::bias, {axis.mean.value, axis.mean.low - frame::wgs84::earth_rate_radps,
                                  axis.mean.high + frame::wgs84::earth_rate_radps});
}

void put_reference(MeasuredGrade& grade, const DeviceFigures& figures,
                   const AgainstReference& against) {
  if (against.axis < 0) return;
  for (const Quantity& quantity : quantities_of(figures.subject.kind)) {
    if (quantity.place != against.place) continue;
    const Place place(grade, quantity.errors, static_cast<std::size_t>(against.axis));
    const auto& [scale, drift] = std::pair(against.comparison.scale, against.comparison.drift);
    // If an angle was compared, its drift is the bias of the rate.
    place.put(&SensorErrors::bias, drift ? *drift : against.comparison.bias);
    if (scale)
      place.put(&SensorErrors::scale_factor, {scale->value - 1, scale->low - 1, scale->high - 1});
  }
}

}  // namespace

MeasuredGrade grade_of(const DeviceFigures& figures) {
  MeasuredGrade grade;
  const double rate_hz = figures.timing.rate_hz.value;
  const bool timed = figures.subject.times != Subject::Times::none;
  if (timed) grade.value.rate_hz = rate_hz;
  grade.value.latency_s = std::max(0.0, figures.utc_latency_s.value_or(0));
  if (figures.timing.outages > 0)
    grade.value.dropout = {figures.timing.outage_probability.value, figures.timing.mean_outage};
  for (const QuantityFigures& of : figures.quantities) {
    const auto quantity = of.quantity.errors;
    for (std::size_t i = 0; i < of.axes.size(); ++i) {
      const auto& axis = of.axes[i];
      if (!axis) continue;
      const Place place(grade, quantity, i);
      put_step(place, *axis, of.steady(), rate_hz, grade.value.*quantity);
      if (!timed || !of.steady()) continue;
      if (axis->noise) put_noise(place, *axis, of.quantity, rate_hz);
      if (of.quantity.name == "gyro") put_bias_at_rest(place, *axis);
    }
    (grade.value.*quantity).correlation_s = correlation_of(of);
  }
  for (const auto& against : figures.against) put_reference(grade, figures, against);
  return grade;
}

EmulateConfig in_measured_form(EmulateConfig grade, rig_config::DeviceKind kind, double rate_hz) {
  for (const Quantity& quantity : quantities_of(kind)) {
    SensorErrors& errors = grade.*quantity.errors;
    for (std::size_t i = 0; i < errors.noise.size(); ++i) {
      const double density =
          std::hypot(errors.noise_density[i], errors.noise[i] / std::sqrt(rate_hz));
      errors.noise_density[i] = quantity.by_density ? density : 0;
      errors.noise[i] = quantity.by_density ? 0 : density * std::sqrt(rate_hz);
    }
  }
  return grade;
}

}  // namespace drydock::characterize

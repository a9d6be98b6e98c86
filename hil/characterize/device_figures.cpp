#include "hil/characterize/device_figures.hpp"

#include <algorithm>
#include <cmath>

#include "hil/characterize/noise/step.hpp"

namespace drydock::characterize {
namespace {

std::vector<double> readings_of(const std::vector<Eigen::Vector3d>& samples, Eigen::Index axis) {
  std::vector<double> readings;
  readings.reserve(samples.size());
  for (const auto& sample : samples)
    if (std::isfinite(sample[axis])) readings.push_back(sample[axis]);
  return readings;
}

/// The mean and the error that noise alone gives it. Its variance is half the variance of the
/// difference of the means of two adjacent recordings of this length.
Estimate mean_of(const std::vector<double>& readings, double period_s,
                 const std::optional<NoiseFit>& noise) {
  double mean = 0;
  for (const double x : readings) mean += (x - readings[0]) / static_cast<double>(readings.size());
  mean += readings[0];
  if (!noise) return {mean, mean, mean};
  const double duration_s = period_s * static_cast<double>(readings.size());
  return normal_estimate(mean, std::sqrt(noise->model.allan_variance(duration_s)));
}

constexpr std::size_t fewest = 10;

/// Without times only the number of samples.
std::optional<TimingFigures> times_told(const Samples& samples) {
  if (samples.subject.times != Subject::Times::none) {
    auto timing = timing_of(samples.origins);
    if (timing && samples.subject.times == Subject::Times::of_device)
      timing->device_rate_hz.reset();
    return timing;
  }
  if (samples.origins.size() < fewest) return std::nullopt;
  TimingFigures timing;
  timing.samples = samples.origins.size();
  return timing;
}

std::optional<AxisFigures> axis_figures(const std::vector<double>& readings,
                                        const DeviceFigures& device, const Quantity& quantity) {
  if (readings.size() < fewest) return std::nullopt;
  AxisFigures axis;
  axis.readings = readings.size();
  axis.step = quantisation_step(readings);
  const bool timed = device.subject.times != Subject::Times::none;
  const double period_s = timed ? 1 / device.timing.rate_hz.value : 0;
  if (!timed) {
    axis.mean = mean_of(readings, period_s, axis.noise);
    return axis;
  }
  axis.curve = allan_curve(readings, period_s);
  axis.noise = fit_noise(axis.curve, {.walk = quantity.walks});
  axis.mean = mean_of(readings, period_s, axis.noise);
  axis.steadiness = steadiness_of(readings, period_s, quantity.change);
  return axis;
}

}  // namespace

bool QuantityFigures::steady() const {
  return std::ranges::all_of(axes,
                             [](const auto& axis) { return !axis || axis->steadiness.steady; });
}

std::optional<DeviceFigures> figures_of(const Samples& samples) {
  const auto timing = times_told(samples);
  if (!timing) return std::nullopt;
  DeviceFigures figures;
  figures.subject = samples.subject;
  figures.timing = *timing;
  for (const Quantity& quantity : quantities_of(samples.subject.kind)) {
    QuantityFigures of{quantity, {}};
    const auto& series = samples.quantities[static_cast<std::size_t>(quantity.place)];
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      of.axes.push_back(axis_figures(readings_of(series, axis), figures, quantity));
    if (std::ranges::any_of(of.axes, [](const auto& axis) { return axis.has_value(); }))
      figures.quantities.push_back(std::move(of));
  }
  figures.sound_speed = samples.sound_speed.means();
  if (!samples.utc_latency_s.empty()) {
    double sum = 0;
    for (const double latency : samples.utc_latency_s) sum += latency;
    figures.utc_latency_s = sum / static_cast<double>(samples.utc_latency_s.size());
  }
  return figures;
}

}  // namespace drydock::characterize

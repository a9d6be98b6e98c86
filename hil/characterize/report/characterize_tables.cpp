#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drivers/measurement/units.hpp"
#include "hil/characterize/report/characterize.hpp"
#include "hil/characterize/report/sound_speed_table.hpp"
#include "rig_config/sensor_file.hpp"

namespace drydock::characterize {
namespace {

using characterize::AxisFigures;
using characterize::Estimate;
using characterize::QuantityFigures;
using rig_config::Axes;
using rig_config::ErrorKey;

std::string bounds(const Estimate& e, double unit = 1) {
  return fmt::format("{:.5g} to {:.5g}", e.low / unit, e.high / unit);
}

report::Table timing_table(const Characterized& device) {
  const auto& t = device.figures.timing;
  report::Table table{
      device.figures.subject.name + ": time", {"", "measured", "95 %", "stated"}, {}, {}};
  const double nominal = device.figures.subject.nominal_rate_hz;
  const auto row = [&](std::string name, std::string value, std::string range = "",
                       std::string stated = "") {
    table.rows.push_back({std::move(name), std::move(value), std::move(range), std::move(stated)});
  };
  if (device.figures.subject.times == Subject::Times::none) {
    row("samples", std::to_string(t.samples));
    table.note = "Without times there is no rate, no noise over time and no sensor file.";
    return table;
  }
  const bool by_device = device.figures.subject.times == Subject::Times::of_device;
  row(by_device ? "rate by the device's own clock [Hz]" : "rate by the host's clock [Hz]",
      fmt::format("{:.8g}", t.rate_hz.value),
      fmt::format("{:.8g} to {:.8g}", t.rate_hz.low, t.rate_hz.high),
      nominal > 0 ? fmt::format("{:g}", nominal) : "");
  if (t.device_rate_hz)
    row("device's clock against the host's [ppm]",
        fmt::format("{:.2f}", (t.rate_hz.value / t.device_rate_hz->value - 1) * 1e6));
  row("jitter, rms [ms]", fmt::format("{:.4f}", t.jitter_s * 1e3));
  row("jitter, largest [ms]", fmt::format("{:.4f}", t.largest_jitter_s * 1e3));
  if (!by_device) {
    row("age on arrival [ms]", fmt::format("{:.3f}", t.latency_s * 1e3));
    row("age on arrival, spread [ms]", fmt::format("{:.4f}", t.latency_spread_s * 1e3));
    row("age on arrival, largest [ms]", fmt::format("{:.3f}", t.largest_latency_s * 1e3));
  }
  if (device.figures.utc_latency_s)
    row("latency by its own UTC [ms]", fmt::format("{:.3f}", *device.figures.utc_latency_s * 1e3));
  row("samples", std::to_string(t.samples));
  row("lost", std::to_string(t.lost), fmt::format("in {} outages", t.outages));
  row("an outage begins, a sample", fmt::format("{:.3g}", t.outage_probability.value),
      bounds(t.outage_probability));
  if (t.pauses > 0)
    row("pauses [s]", fmt::format("{:.2f}", t.paused_s),
        fmt::format("{} of more than 100 periods: no outages", t.pauses));
  table.note = by_device
                   ? "The capture has no times of arrival: no age, no drift of the clock."
                   : "Age on arrival: wire time and stated latency, as the driver accounts for "
                     "them.";
  return table;
}

/// "better" or "worse" if the data sheet value lies outside the bounds. Small biases and scale
/// errors count as good.
std::string verdict(double low, double high, double stated) {
  if (stated == 0) return "";
  const double smallest = low <= 0 && high >= 0 ? 0 : std::min(std::abs(low), std::abs(high));
  const double largest = std::max(std::abs(low), std::abs(high));
  if (smallest > std::abs(stated)) return "worse";
  return largest < std::abs(stated) ? "better" : "as stated";
}

report::Table grade_table(const Characterized& device) {
  const auto kind = device.figures.subject.kind;
  const auto stated = device.beside
                          ? characterize::in_measured_form(device.beside->grade, kind,
                                                           device.figures.timing.rate_hz.value)
                          : rig_config::EmulateConfig{};
  report::Table table{
      device.figures.subject.name + ": errors, 1 sigma",
      {"", "axis", "measured", "95 %", device.beside ? device.beside->name : "data sheet", ""},
      {},
      {}};
  for (const ErrorKey& key : rig_config::error_keys) {
    if (key.kind != kind) continue;
    const Axes &value = device.measured.value.*key.quantity.*key.part,
               &low = device.measured.low.*key.quantity.*key.part,
               &high = device.measured.high.*key.quantity.*key.part,
               &sheet = stated.*key.quantity.*key.part;
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (value[i] == 0) continue;
      table.rows.push_back({key.key, std::string(1, "xyz"[i]),
                            fmt::format("{:.5g}", value[i] / key.unit),
                            bounds({value[i], low[i], high[i]}, key.unit),
                            sheet[i] != 0 ? fmt::format("{:.5g}", sheet[i] / key.unit) : "",
                            verdict(low[i], high[i], sheet[i])});
    }
  }
  for (const QuantityFigures& of : device.figures.quantities)
    if (!of.steady())
      table.note += fmt::format(
          "{} was moving: its noise is not told from its motion, so none is "
          "given; lay it still. ",
          of.quantity.name);
  return table;
}

report::Table process_table(const Characterized& device, const QuantityFigures& of) {
  report::Table table{
      fmt::format("{}: {} [{}]", device.figures.subject.name, of.quantity.name, of.quantity.unit),
      {"axis", "mean", "95 %", "step", "correlation [s]", "95 %", "instability from Allan minimum",
       "at tau [s]"},
      {},
      of.steady() ? "" : "Moving: figures include the motion."};
  for (std::size_t i = 0; i < of.axes.size(); ++i) {
    const auto& axis = of.axes[i];
    if (!axis) continue;
    const double unit = of.quantity.in_si;
    const auto& time = axis->noise ? axis->noise->correlation_s : std::nullopt;
    // IEEE Std 952: the flat part of the curve is B sqrt(2 ln 2 / pi).
    constexpr double flicker = 0.6642824702679600;
    const auto least = std::ranges::min_element(axis->curve.variance);
    const bool any = least != axis->curve.variance.end();
    const auto at = static_cast<std::size_t>(least - axis->curve.variance.begin());
    table.rows.push_back({std::string(of.quantity.axes[i]),
                          fmt::format("{:.6g}", axis->mean.value / unit), bounds(axis->mean, unit),
                          axis->step ? fmt::format("{:.6g}", *axis->step / unit) : "",
                          time ? fmt::format("{:.4g}", time->value) : "", time ? bounds(*time) : "",
                          any ? fmt::format("{:.4g}", std::sqrt(*least) / flicker / unit) : "",
                          any ? fmt::format("{:.4g}", axis->curve.tau_s(at)) : ""});
  }
  return table;
}

report::Table reference_table(const Characterized& device) {
  report::Table table{device.figures.subject.name + ": against a reference",
                      {"", "reference", "scale", "95 %", "angle [deg]", "95 %", "bias", "95 %",
                       "delay [ms]", "95 %", "residual", "blocks"},
                      {},
                      "SI. Bounds are of the comparison; the reference's own errors are in it."};
  for (const auto& against : device.figures.against) {
    const auto& c = against.comparison;
    const auto bias = c.drift.value_or(c.bias);
    table.rows.push_back(
        {c.what, against.reference, c.scale ? fmt::format("{:.6f}", c.scale->value) : "",
         c.scale ? bounds(*c.scale) : "",
         c.angle_rad ? fmt::format("{:.3f}", c.angle_rad->value / units::degree) : "",
         c.angle_rad ? bounds(*c.angle_rad, units::degree) : "", fmt::format("{:.5g}", bias.value),
         bounds(bias), c.delay_s ? fmt::format("{:.2f}", c.delay_s->value * 1e3) : "",
         c.delay_s ? bounds(*c.delay_s, 1e-3) : "", fmt::format("{:.4g}", c.residual),
         std::to_string(c.blocks)});
  }
  return table;
}

/// The Allan deviation of an axis that the grade promises.
double promised(const rig_config::SensorErrors& errors, std::size_t axis, double rate_hz,
                double tau) {
  const characterize::NoiseModel model{
      .quantisation =
          errors.quantisation_carried ? errors.quantisation[axis] / rate_hz / std::sqrt(12.0) : 0,
      .density = errors.noise_density[axis] + errors.noise[axis] / std::sqrt(rate_hz),
      .instability = errors.bias_instability[axis],
      .correlation_s = errors.correlation_s,
      .walk = errors.random_walk[axis]};
  return std::sqrt(model.allan_variance(tau));
}

report::Figure allan_figure(const Characterized& device, const QuantityFigures& of) {
  const double unit = of.quantity.in_si;
  report::Figure figure{fmt::format("{}: Allan deviation, {}{}", device.figures.subject.name,
                                    of.quantity.name, of.steady() ? "" : " (moving)"),
                        "tau [s]",
                        std::string(of.quantity.unit),
                        {}};
  figure.log_x = figure.log_y = true;
  const auto name = [&](std::size_t i) {
    const auto axis = of.quantity.axes[i];
    return axis.empty() ? std::string("measured") : std::string(axis);
  };
  for (std::size_t i = 0; i < of.axes.size(); ++i) {
    const auto& axis = of.axes[i];
    if (!axis) continue;
    report::Curve measured{name(i), {}, {}, false, true}, fitted{name(i) + ", fit", {}, {}};
    for (std::size_t k = 0; k < axis->curve.samples.size(); ++k) {
      const double tau = axis->curve.tau_s(k);
      if (!(axis->curve.variance[k] > 0)) continue;
      measured.x.push_back(tau);
      measured.y.push_back(std::sqrt(axis->curve.variance[k]) / unit);
      if (!axis->noise) continue;
      fitted.x.push_back(tau);
      fitted.y.push_back(std::sqrt(axis->noise->model.allan_variance(tau)) / unit);
    }
    if (!measured.x.empty()) figure.curves.push_back(std::move(measured));
    if (!fitted.x.empty()) figure.curves.push_back(std::move(fitted));
  }
  if (!device.beside || figure.curves.empty()) return figure;
  report::Curve stated{device.beside->name, {}, {}};
  const auto& errors = device.beside->grade.*of.quantity.errors;
  for (const double tau : figure.curves.front().x) {
    const double y = promised(errors, 0, device.figures.timing.rate_hz.value, tau) / unit;
    if (!(y > 0)) continue;
    stated.x.push_back(tau);
    stated.y.push_back(y);
  }
  if (!stated.x.empty()) figure.curves.push_back(std::move(stated));
  return figure;
}

}  // namespace

std::vector<report::Table> tables_of(const Characterized& device) {
  std::vector<report::Table> tables{timing_table(device), grade_table(device)};
  for (const auto& of : device.figures.quantities) tables.push_back(process_table(device, of));
  if (const auto& sound = device.figures.sound_speed)
    tables.push_back(sound_speed_table(device.figures.subject.name, *sound));
  if (!device.figures.against.empty()) tables.push_back(reference_table(device));
  return tables;
}

std::vector<report::Figure> figures_of(const Characterized& device) {
  std::vector<report::Figure> figures;
  for (const auto& of : device.figures.quantities)
    if (auto figure = allan_figure(device, of); !figure.curves.empty())
      figures.push_back(std::move(figure));
  return figures;
}

std::string sensor_file_of(const Characterized& device, const std::string& source) {
  const auto& figures = device.figures;
  std::string head = fmt::format(
      "{} of {}, measured by drydock characterize: {} samples, {:.6g} s. 95 % bounds behind each\n"
      "figure, axis by axis. Correlation times and dropouts: docs/sensors/characterize.md.\n",
      figures.subject.name, source, figures.timing.samples,
      static_cast<double>(figures.timing.samples) / figures.timing.rate_hz.value);
  for (const QuantityFigures& of : figures.quantities)
    if (!of.steady())
      head += fmt::format("The {} was moving: its noise is not known and left out.\n",
                          of.quantity.name);
  return rig_config::sensor_text(figures.subject.kind, device.measured.value, head,
                                 [&](const ErrorKey& key) {
                                   const Axes &low = device.measured.low.*key.quantity.*key.part,
                                              &high = device.measured.high.*key.quantity.*key.part;
                                   return rig_config::figures_text(low, key.unit, 4) + " to " +
                                          rig_config::figures_text(high, key.unit, 4);
                                 });
}

}  // namespace drydock::characterize

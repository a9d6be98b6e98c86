#include <cmath>

#include "hil/characterize/report/characterize.hpp"
#include "rig_config/sensor_file.hpp"

namespace drydock::characterize {
namespace {

using characterize::Estimate;
using nlohmann::ordered_json;

ordered_json of(const Estimate& e) {
  return {{"value", e.value}, {"low", e.low}, {"high", e.high}};
}
ordered_json of(const std::optional<Estimate>& e) { return e ? of(*e) : ordered_json(nullptr); }

ordered_json timing_json(const characterize::DeviceFigures& figures) {
  const auto& t = figures.timing;
  if (figures.subject.times == Subject::Times::none) return {{"samples", t.samples}};
  return {{"samples", t.samples},
          {"rate_hz", of(t.rate_hz)},
          {"device_rate_hz", of(t.device_rate_hz)},
          {"jitter_s", t.jitter_s},
          {"largest_jitter_s", t.largest_jitter_s},
          {"age_s", t.latency_s},
          {"age_spread_s", t.latency_spread_s},
          {"largest_age_s", t.largest_latency_s},
          {"utc_latency_s", figures.utc_latency_s ? ordered_json(*figures.utc_latency_s) : nullptr},
          {"outages", t.outages},
          {"lost", t.lost},
          {"outage_probability", of(t.outage_probability)},
          {"mean_outage_samples", t.mean_outage},
          {"pauses", t.pauses},
          {"paused_s", t.paused_s}};
}

ordered_json axis_json(const characterize::AxisFigures& axis) {
  ordered_json curve = ordered_json::array();
  for (std::size_t i = 0; i < axis.curve.samples.size(); ++i) {
    ordered_json point{{"tau_s", axis.curve.tau_s(i)},
                       {"deviation", std::sqrt(axis.curve.variance[i])}};
    if (axis.noise) point["bounds"] = of(axis.noise->deviation[i]);
    curve.push_back(std::move(point));
  }
  ordered_json json{{"mean", of(axis.mean)},
                    {"step", axis.step ? ordered_json(*axis.step) : nullptr},
                    {"steady", axis.steadiness.steady},
                    {"change", axis.steadiness.change}};
  if (axis.noise) {
    json["quantisation"] = of(axis.noise->quantisation);
    json["density"] = of(axis.noise->density);
    json["instability"] = of(axis.noise->instability);
    json["correlation_s"] = of(axis.noise->correlation_s);
    json["walk"] = of(axis.noise->walk);
  }
  json["allan"] = std::move(curve);
  return json;
}

ordered_json comparison_json(const characterize::AgainstReference& against) {
  const auto& c = against.comparison;
  return {{"what", c.what},           {"reference", against.reference},
          {"scale", of(c.scale)},     {"angle_rad", of(c.angle_rad)},
          {"bias", of(c.bias)},       {"drift", of(c.drift)},
          {"delay_s", of(c.delay_s)}, {"residual", c.residual},
          {"blocks", c.blocks}};
}

ordered_json sound_speed_json(const measurement::SoundSpeedUsed::Means& means) {
  return {
      {"used_mps", means.used_mps},
      {"of_water_mps", means.of_water_mps},
      {"velocity_error", means.error()},
      {"equation", measurement::sound_speed_equations[static_cast<std::size_t>(means.equation)]},
      {"temperature_k", means.temperature_k},
      {"salinity_ppt", means.salinity_ppt},
      {"depth_m", means.depth_m},
      {"samples", means.samples}};
}

/// Keys and units are those of a sensor file.
ordered_json grade_json(const Characterized& device) {
  ordered_json json = ordered_json::object();
  for (const auto& key : rig_config::error_keys) {
    const auto& value = device.measured.value.*key.quantity.*key.part;
    if (key.kind != device.figures.subject.kind || value == rig_config::Axes{}) continue;
    ordered_json axes = ordered_json::array();
    for (std::size_t i = 0; i < value.size(); ++i)
      axes.push_back(of(Estimate{value[i] / key.unit,
                                 (device.measured.low.*key.quantity.*key.part)[i] / key.unit,
                                 (device.measured.high.*key.quantity.*key.part)[i] / key.unit}));
    json[key.key] = std::move(axes);
  }
  return json;
}

}  // namespace

nlohmann::ordered_json json_of(const Characterized& device) {
  ordered_json json{{"device", device.figures.subject.name},
                    {"timing", timing_json(device.figures)},
                    {"grade", grade_json(device)},
                    {"data_sheet", device.beside ? ordered_json(device.beside->name) : nullptr}};
  for (const auto& quantity : device.figures.quantities) {
    ordered_json axes = ordered_json::array();
    for (const auto& axis : quantity.axes) axes.push_back(axis ? axis_json(*axis) : nullptr);
    json[std::string(quantity.quantity.name)] = std::move(axes);
  }
  if (const auto& sound = device.figures.sound_speed)
    json["sound_speed"] = sound_speed_json(*sound);
  json["against"] = ordered_json::array();
  for (const auto& against : device.figures.against)
    json["against"].push_back(comparison_json(against));
  return json;
}

}  // namespace drydock::characterize

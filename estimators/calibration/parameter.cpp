#include "estimators/calibration/parameter.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <set>

namespace drydock::calibration {
namespace {

using smoothing::Quantity;

constexpr double degree = std::numbers::pi / 180;

struct Facts {
  std::string_view name, unit;
  double prior;
};

constexpr std::array<Facts, 9> facts{{{"yaw", "rad", 5 * degree},
                                      {"pitch", "rad", 5 * degree},
                                      {"scale", "1", 0.05},
                                      {"latency", "s", 0.5},
                                      {"lever ahead", "m", 1},
                                      {"lever to starboard", "m", 1},
                                      {"deviation, constant", "rad", 5 * degree},
                                      {"deviation, sine", "rad", 5 * degree},
                                      {"deviation, cosine", "rad", 5 * degree}}};

const Facts& facts_of(Unknown unknown) { return facts.at(static_cast<std::size_t>(unknown)); }

std::set<std::uint16_t> devices_with(const smoothing::Dive& dive, Quantity quantity) {
  std::set<std::uint16_t> devices;
  for (const auto& reading : dive.readings)
    if (reading.quantity == quantity) devices.insert(reading.device);
  return devices;
}

}  // namespace

std::string_view name_of(Unknown unknown) { return facts_of(unknown).name; }
std::string_view unit_of(Unknown unknown) { return facts_of(unknown).unit; }
double usual_prior(Unknown unknown) { return facts_of(unknown).prior; }

void apply(const Parameter& parameter, double value, smoothing::SensorModels& models) {
  if (models.size() <= parameter.device) models.resize(parameter.device + 1U);
  auto& model = models[parameter.device];
  switch (parameter.unknown) {
    case Unknown::yaw: model.yaw_rad += value; break;
    case Unknown::pitch: model.pitch_rad += value; break;
    case Unknown::scale: model.scale_error += value; break;
    case Unknown::latency: model.latency_s += value; break;
    case Unknown::lever_ahead: model.lever.x() += value; break;
    case Unknown::lever_starboard: model.lever.y() += value; break;
    case Unknown::deviation_constant: model.deviation_rad[0] += value; break;
    case Unknown::deviation_sine: model.deviation_rad[1] += value; break;
    case Unknown::deviation_cosine: model.deviation_rad[2] += value; break;
  }
}

std::vector<Parameter> parameters_of(const smoothing::Dive& dive) {
  std::vector<Parameter> all;
  const auto add = [&](std::uint16_t device, std::initializer_list<Unknown> unknowns) {
    for (const Unknown unknown : unknowns) all.push_back({device, unknown, usual_prior(unknown)});
  };
  const auto tracks = devices_with(dive, Quantity::bottom);
  for (const auto device : tracks)
    add(device, {Unknown::yaw, Unknown::pitch, Unknown::scale, Unknown::latency,
                 Unknown::lever_ahead, Unknown::lever_starboard});
  std::set<std::uint16_t> timed = tracks;
  const auto add_latency = [&](std::uint16_t device) {
    if (timed.insert(device).second) add(device, {Unknown::latency});
  };
  for (const auto device : devices_with(dive, Quantity::log)) {
    add(device, {Unknown::scale});
    add_latency(device);
  }
  for (const auto device : devices_with(dive, Quantity::heading)) {
    if (tracks.empty()) add(device, {Unknown::deviation_constant});
    add(device, {Unknown::deviation_sine, Unknown::deviation_cosine});
    add_latency(device);
  }
  for (const auto device : devices_with(dive, Quantity::depth)) add_latency(device);
  return all;
}

}  // namespace drydock::calibration

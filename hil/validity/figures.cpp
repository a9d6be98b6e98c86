#include "hil/validity/figures.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "hil/validity/pairing.hpp"

namespace drydock::validity {
namespace {

/// Names the measurements that come from separate messages, each with its own time.
struct WhatItSays {
  std::string_view operator()(const measurement::ImuSample&) const { return "sample"; }
  std::string_view operator()(const measurement::BottomVelocity&) const { return "velocity"; }
  std::string_view operator()(const measurement::GnssFix&) const { return "fix"; }
  std::string_view operator()(const measurement::GnssSatellites&) const { return "satellites"; }
  std::string_view operator()(const measurement::WaterSpeed& m) const {
    return m.distance_m ? "distance" : "speed";
  }
  std::string_view operator()(const measurement::DepthSample& m) const {
    return m.pressure_pa ? "pressure" : "bed below";
  }
  std::string_view operator()(const measurement::ActuatorState& m) const {
    if (m.rudder_rad) return "rudder";
    if (m.stern_plane_rad) return "stern plane";
    return m.bow_plane_rad ? "bow plane" : "shaft";
  }
  std::string_view operator()(const measurement::AttitudeSample& m) const {
    if (m.rate_of_turn_radps) return "rate of turn";
    return m.heading_rad ? "heading" : "tilt";
  }
};

double microseconds(Stamp::duration d) { return static_cast<double>(d.count()) / 1e3; }

}  // namespace

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  const auto part = [&](double share) {
    const auto place = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
    return values[place];
  };
  std::ranges::sort(values);
  Spread spread;
  spread.median_us = part(0.5);
  for (double& value : values) value = std::abs(value);
  std::ranges::sort(values);
  spread.p50_us = part(0.5);
  spread.p95_us = part(0.95);
  spread.p99_us = part(0.99);
  spread.largest_us = values.back();
  return spread;
}

void Listener::note(std::string_view name, const emulate::Passage& passage, Stamp written) {
  if (!passage.sampled_at) return;
  const auto device = std::ranges::find(devices_, name, &Device::name);
  if (device == devices_.end()) return;
  auto& sent = device->sent;
  if (!sent.empty() && sent.back().sampled_at == *passage.sampled_at) return;
  sent.push_back(
      {*passage.sampled_at, passage.sent_at, passage.began_at, passage.ended_at, written});
}

void Listener::note(const measurement::Measurement& m, Stamp out_at) {
  const auto& origin = measurement::origin_of(m);
  auto& aspects = devices_.at(origin.device).aspects;
  const std::string_view what = std::visit(WhatItSays{}, m);
  auto aspect = std::ranges::find(aspects, what, &Aspect::what);
  if (aspect == aspects.end()) aspect = aspects.insert(aspects.end(), Aspect{what, {}, {}});
  aspect->valid_at.push_back(origin.valid_at);
  aspect->out_at.push_back(out_at);
}

std::vector<Stamp> Listener::sampled_at_of(const Device& device) {
  std::vector<Stamp> sampled_at;
  sampled_at.reserve(device.sent.size());
  for (const Sent& sent : device.sent) sampled_at.push_back(sent.sampled_at);
  return sampled_at;
}

std::vector<Stamp> Listener::sampled_at(std::string_view name) const {
  const auto device = std::ranges::find(devices_, name, &Device::name);
  return device == devices_.end() ? std::vector<Stamp>{} : sampled_at_of(*device);
}

Figures Listener::figures_of(const Device& device, const Aspect& aspect) {
  Figures figures{device.name, std::string(aspect.what), 0, 0, {}, {}, {}, {}, {}, {}};
  const auto pairs = pair(aspect.valid_at, sampled_at_of(device));
  std::optional<std::size_t> first, last;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!pairs[i]) {
      ++figures.unpaired;
      continue;
    }
    if (!first) first = pairs[i];
    last = pairs[i];
    const Sent& sent = device.sent[*pairs[i]];
    figures.errors_us.push_back(microseconds(aspect.valid_at[i] - sent.sampled_at));
    figures.waited_us.push_back(microseconds(sent.began_at - sent.sent_at));
    figures.late_us.push_back(microseconds(sent.written - sent.ended_at));
    figures.rest_us.push_back(figures.errors_us.back() - figures.waited_us.back() -
                              figures.late_us.back());
    figures.sampled_at.push_back(sent.sampled_at);
    figures.out_at.push_back(aspect.out_at[i]);
  }
  if (first) figures.lost = *last - *first + 1 - figures.errors_us.size();
  return figures;
}

std::vector<Figures> Listener::figures() const {
  std::vector<Figures> all;
  for (const Device& device : devices_)
    for (const Aspect& aspect : device.aspects) all.push_back(figures_of(device, aspect));
  return all;
}

}  // namespace drydock::validity

#include "hil/scorecard/wrong_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "rig_config/fault_vocabulary.hpp"

namespace drydock::scorecard {
namespace {

using rig_config::FaultKind;
using rig_config::FaultLayer;

/// One number of a message.
struct Part {
  std::uint32_t series = 0;
  const Series* of = nullptr;
  Sample sample;
};

/// A message of one device with at least one unexpected number.
struct Suspect {
  std::vector<Part> parts;  ///< all numbers of the message
  Part wrong;               ///< the first unexpected number
  bool of_driver = false;
};

std::map<std::size_t, Suspect> suspects_of(std::size_t device, const Window& window,
                                           const Pair& pair, const Reference& reference,
                                           const DeviceRecord& now) {
  std::map<std::size_t, Suspect> suspects;  // by message
  for (const auto& [key, series] : now.series) {
    const Blame blame = device == pair.device ? blame_for(series.role, pair.fault) : Blame::driver;
    if (blame == Blame::nobody) continue;
    for (const Sample& sample : series.samples) {
      if (sample.received_s < window.warm_up_s || reference.sound(device, key, sample)) continue;
      auto& suspect = suspects[sample.message];
      if (!suspect.wrong.of) suspect.wrong = {key, &series, sample};
      suspect.of_driver |= blame == Blame::driver;
    }
  }
  for (const auto& [key, series] : now.series)
    for (const Sample& sample : series.samples)
      if (const auto found = suspects.find(sample.message); found != suspects.end())
        found->second.parts.push_back({key, &series, sample});
  return suspects;
}

/// True if all numbers of the message were as expected at one earlier time.
bool was_true_before(std::size_t device, const Suspect& suspect, const Reference& reference) {
  constexpr double reach_s = 4, slack_s = 0.05;
  const auto& series = reference.run().devices.at(device).series;
  const auto usual = series.find(suspect.wrong.series);
  if (usual == series.end()) return false;
  const double said_s = suspect.wrong.sample.valid_s;
  const auto true_at = [&](double at_s) {
    return std::ranges::all_of(suspect.parts, [&](const Part& part) {
      Sample moved = part.sample;
      moved.valid_s = at_s;
      return reference.sound(device, part.series, moved);
    });
  };
  const auto& samples = usual->second.samples;
  auto at = std::ranges::upper_bound(samples, said_s + slack_s, {}, &Sample::valid_s);
  while (at != samples.begin() && (--at)->valid_s > said_s - reach_s)
    if (true_at(at->valid_s)) return true;
  return false;
}

std::string in_words(const std::string& device, std::size_t index, const Part& part,
                     const Reference& reference) {
  const auto expected = reference.at(index, part.series, part.sample.valid_s);
  return fmt::format(
      "{} {} = {:.6g} at {:.3f} s, {}", device, part.of->name, part.sample.value,
      part.sample.valid_s,
      expected ? fmt::format("expected {:.6g} +- {:.2g}", expected->value, expected->tolerance)
               : std::string("when it said nothing"));
}

}  // namespace

Blame blame_for(Role role, const rig_config::FaultConfig& fault) {
  const FaultLayer layer = rig_config::word_of(fault.kind).layer;
  if (layer == FaultLayer::measurement) {
    if (role == Role::total) return Blame::nobody;
    return fault.kind == FaultKind::off ? Blame::driver : Blame::sensor;
  }
  if (role == Role::quality && layer == FaultLayer::environment) return Blame::nobody;
  const bool clock = fault.kind == FaultKind::clock_step || fault.kind == FaultKind::clock_drift;
  return role == Role::clock && clock ? Blame::sensor : Blame::driver;
}

WrongNumbers wrong_numbers(const rig_config::Rig& rig, const Window& window, const Pair& pair,
                           const Reference& reference, const RunRecord& run) {
  WrongNumbers found;
  std::string mistimed_example;
  for (std::size_t device = 0; device < run.devices.size(); ++device) {
    const std::string& name = rig.devices[device].name;
    for (const auto& [message, suspect] :
         suspects_of(device, window, pair, reference, run.devices[device])) {
      if (!suspect.of_driver) {
        ++found.of_sensor;
        continue;
      }
      const bool mistimed = was_true_before(device, suspect, reference);
      ++(mistimed ? found.mistimed : found.of_driver);
      std::string& example = mistimed ? mistimed_example : found.example;
      if (example.empty()) example = in_words(name, device, suspect.wrong, reference);
    }
  }
  if (found.example.empty()) found.example = std::move(mistimed_example);
  return found;
}

}  // namespace drydock::scorecard

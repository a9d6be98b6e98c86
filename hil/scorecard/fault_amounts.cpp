#include "hil/scorecard/fault_amounts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "drivers/link/uri.hpp"
#include "rig_config/fault_quantity.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "rig_config/load.hpp"

namespace drydock::scorecard {
namespace {

using rig_config::DeviceConfig;
using rig_config::FaultKind;
using rig_config::FaultQuantity;
using rig_config::FaultWord;

/// The size of the error for each measurement fault: well beyond the noise, but plausible. A spike
/// is a motion that no vehicle can make.
struct QuantityAmount {
  rig_config::DeviceKind kind;
  std::string_view key;
  double off, wrong, spike;
};

constexpr QuantityAmount quantity_amounts[] = {
    {rig_config::DeviceKind::dvl, "velocity_mps", 0.3, 1, 5},
    {rig_config::DeviceKind::emlog, "speed_mps", 0.5, 1, 10},
    {rig_config::DeviceKind::gnss, "position_m", 30, 100, 1000},
    {rig_config::DeviceKind::gnss, "velocity_mps", 1, 0, 50},
    {rig_config::DeviceKind::imu, "rate_degps", 1, 5, 100},
    {rig_config::DeviceKind::imu, "specific_force_mps2", 0.5, 1, 20},
    {rig_config::DeviceKind::depth, "pressure_pa", 20e3, 150e3, 1e6},
    {rig_config::DeviceKind::actuator, "angle_deg", 5, 10, 30},
    {rig_config::DeviceKind::actuator, "shaft_rpm", 100, 0, 1000},
    {rig_config::DeviceKind::attitude, "attitude_deg", 5, 10, 30},
    {rig_config::DeviceKind::attitude, "turn_degps", 2, 5, 50},
};

const QuantityAmount& amount_of(const FaultQuantity& quantity) {
  for (const auto& amount : quantity_amounts)
    if (amount.kind == quantity.kind && amount.key == quantity.key) return amount;
  throw std::logic_error(fmt::format("the scorecard has no amount of {}", quantity.key));
}

std::string text_of(const FaultQuantity& quantity, FaultKind kind) {
  const QuantityAmount& amount = amount_of(quantity);
  switch (kind) {
    case FaultKind::wrong: return fmt::format("{} = {}", quantity.key, amount.wrong);
    case FaultKind::spike:
      return fmt::format("{} = {}\nprobability = 0.1", quantity.key, amount.spike);
    case FaultKind::drift: return fmt::format("{} = {}\nwithin_s = 20", quantity.key, amount.off);
    default: return fmt::format("{} = {}", quantity.key, amount.off);
  }
}

/// Twice the line's baud rate, a common mistake in a configuration.
std::string baud_text(const DeviceConfig& device) {
  const auto uri = link::parse_uri(device.link);
  return fmt::format("baud = {}", 2 * (uri ? uri->baud().value_or(9600) : 9600));
}

std::string text_of(const FaultWord& word, const DeviceConfig& device) {
  if (word.kind == FaultKind::wrong_baud) return baud_text(device);
  return std::string(word.facts.scorecard);
}

/// Goes through the text of a fault file, so that the same checks apply.
rig_config::FaultConfig fault_of(const DeviceConfig& device, const FaultWord& word,
                                 const std::string& amount, const Window& window) {
  const auto text =
      fmt::format("[[fault]]\ndevice = \"{}\"\nfault = \"{}\"\nstart_s = {}\nfor_s = {}\n{}\n",
                  device.name, word.name, window.warm_up_s, window.fault_s, amount);
  return rig_config::load_faults_text(text, "scorecard").value().at(0);
}

void add_pairs(const rig_config::Rig& rig, std::size_t index, const FaultWord& word,
               const Window& window, std::vector<Pair>& pairs) {
  const DeviceConfig& device = rig.devices[index];
  const auto add = [&](std::string label, const std::string& amount) {
    Pair pair{index, std::move(label), fault_of(device, word, amount, window)};
    if (!rig_config::refusal(pair.fault, device)) pairs.push_back(std::move(pair));
  };
  if (word.amount != "quantity") return add(std::string(word.name), text_of(word, device));
  const auto quantities =
      std::ranges::count(rig_config::fault_quantities, device.kind, &FaultQuantity::kind);
  for (const auto& quantity : rig_config::fault_quantities) {
    if (quantity.kind != device.kind) continue;
    add(quantities == 1 ? std::string(word.name) : fmt::format("{} {}", word.name, quantity.key),
        text_of(quantity, word.kind));
  }
}

bool chosen(const std::vector<std::string>& selection, std::string_view name) {
  return selection.empty() || std::ranges::find(selection, name) != selection.end();
}

void check_names(std::string_view what, const std::vector<std::string>& asked,
                 const std::vector<std::string>& known) {
  for (const auto& name : asked)
    if (std::ranges::find(known, name) == known.end())
      throw std::runtime_error(
          fmt::format("no {} is named \"{}\", allowed: {}", what, name, fmt::join(known, ", ")));
}

}  // namespace

rig_config::FaultConfig scaled(const rig_config::FaultConfig& fault, double times) {
  const auto comma = fault.words.find(", ");  // "dvl: delay, seconds = 0.5"
  const auto equals = fault.words.find("= ", std::min(comma, fault.words.size()));
  if (times == 1 || equals == fault.words.npos || fault.kind == FaultKind::wrong_baud) return fault;
  const FaultWord& word = rig_config::word_of(fault.kind);
  const bool quantity = word.amount == "quantity";
  const double most = quantity ? rig_config::words::any : word.highest;
  const double least = quantity ? -most : word.lowest;
  const double usual = std::stod(fault.words.substr(equals + 2));
  const double none = word.amount == "times" ? 1 : 0;
  double amount = std::clamp(none + times * (usual - none), least, most);
  if (word.amount == "bytes") amount = std::round(amount);
  const auto key = fault.words.substr(comma + 2, equals - comma - 2);
  DeviceConfig device;
  device.name = fault.device;
  auto same = fault_of(device, word, fmt::format("{}= {:.9g}", key, amount),
                       {.warm_up_s = fault.start_s, .fault_s = *fault.for_s, .after_s = 0});
  if (!word.facts.extra) return same;
  same.within_s = fault.within_s;
  same.probability = fault.probability;
  return same;
}

rig_config::FaultConfig fault_named(const rig_config::Rig& rig, const Window& window,
                                    const std::string& text) {
  const auto colon = text.find(':');
  if (colon == text.npos)
    throw std::runtime_error(fmt::format("\"{}\" is no DEVICE:FAULT, as emlog:bias", text));
  const auto found = pairs_of(rig, window, {text.substr(0, colon)}, {text.substr(colon + 1)});
  if (found.empty()) throw std::runtime_error(fmt::format("\"{}\" cannot happen", text));
  return found.front().fault;
}

std::vector<Pair> pairs_of(const rig_config::Rig& rig, const Window& window,
                           const std::vector<std::string>& devices,
                           const std::vector<std::string>& faults) {
  std::vector<std::string> names, words;
  for (const auto& device : rig.devices) names.push_back(device.name);
  for (const auto& word : rig_config::fault_vocabulary()) words.emplace_back(word.name);
  check_names("device", devices, names);
  check_names("fault", faults, words);

  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < rig.devices.size(); ++i) {
    const auto uri = link::parse_uri(rig.devices[i].link);
    if (!chosen(devices, rig.devices[i].name) || !uri || !uri->emulated()) continue;
    for (const auto& word : rig_config::fault_vocabulary())
      if (chosen(faults, word.name)) add_pairs(rig, i, word, window, pairs);
  }
  return pairs;
}

}  // namespace drydock::scorecard

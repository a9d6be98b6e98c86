#include "hil/twin/rig_text.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "drivers/wire/protocols.hpp"

namespace drydock::twin {
namespace {

/// Keys of [device.emulate] that are no errors of the sensor.
constexpr std::array kept_keys{"boot_s",        "banner",    "first_fix_s", "model",
                               "variation_deg", "reference", "sky",         "head"};
/// Keys of a DVL's head that are errors: they are in the measured noise.
constexpr std::array measured_head_keys{"beam_noise_mps", "sound_speed_mps"};

std::string text_of_key(const toml::table& table, std::string_view key) {
  return table[key].value_or(std::string{});
}

/// toml++ writes 17 digits: 0.20000000000000001. The shortest text of the same number is enough.
std::string with_short_numbers(const std::string& text) {
  static const std::regex number(R"([0-9]+\.[0-9]{15,}(?:e[-+]?[0-9]+)?)");
  std::string out;
  auto last = text.begin();
  for (std::sregex_iterator found(text.begin(), text.end(), number), end; found != end; ++found) {
    out.append(last, text.begin() + found->position());
    out += fmt::format("{}", std::stod(found->str()));
    last = text.begin() + found->position() + found->length();
  }
  return out.append(last, text.end());
}

/// A local time cannot stand for a time in UTC: the text has its offset.
std::string start_text(measurement::Stamp start) {
  const auto at = std::chrono::round<std::chrono::microseconds>(start.time_since_epoch());
  const auto seconds = std::chrono::floor<std::chrono::seconds>(at);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:06}Z",
                     fmt::gmtime(static_cast<std::time_t>(seconds.count())),
                     (at - seconds).count());
}

/// Values that name files get the names of the twin's files.
void rename_files(toml::node& node, const TwinRig& twin) {
  if (auto* table = node.as_table())
    for (auto&& [key, value] : *table) rename_files(value, twin);
  if (auto* array = node.as_array())
    for (auto& value : *array) rename_files(value, twin);
  auto* text = node.as_string();
  if (text == nullptr) return;
  const auto path = (std::filesystem::path(twin.folder) / text->get()).lexically_normal();
  if (const auto found = twin.files.find(path.string()); found != twin.files.end())
    *text = found->second;
}

toml::table twin_errors(const toml::table* recorded, const TwinDevice& twin, double latency_ms) {
  toml::table errors;
  if (!twin.errors.empty()) errors.insert_or_assign("errors", twin.errors);
  if (latency_ms > 0) errors.insert_or_assign("latency_ms", latency_ms);
  if (recorded == nullptr) return errors;
  for (const char* key : kept_keys)
    if (const auto* value = recorded->get(key)) errors.insert_or_assign(key, *value);
  if (auto* head = errors["head"].as_table())
    for (const char* key : measured_head_keys) head->erase(key);
  return errors;
}

bool travels_as_frames(const toml::table& device) {
  const auto* protocol = wire::find_protocol(text_of_key(device, "protocol"));
  if (protocol != nullptr) return protocol->travels == wire::Travels::as_frames;
  const auto link = text_of_key(device, "link");
  return link.find("can") < link.find(':');  // a description: as its link carries it
}

void change_device(toml::table& device, const TwinDevice& twin) {
  device.insert_or_assign(
      "link", emulated_link(text_of_key(device, "link"), twin.name, travels_as_frames(device)));
  if (twin.rate_hz > 0) device.insert_or_assign("rate_hz", twin.rate_hz);
  const double latency_ms = device["latency_ms"].value_or(0.0);
  auto errors = twin_errors(device["emulate"].as_table(), twin, latency_ms);
  device.erase("emulate");
  if (!errors.empty()) device.insert_or_assign("emulate", std::move(errors));
}

/// Tables of `key` with other names are left out.
template <class Named>
void keep_named(toml::table& rig, std::string_view key, Named&& is_named) {
  auto* tables = rig[key].as_array();
  if (tables == nullptr) return;
  for (auto it = tables->begin(); it != tables->end();)
    it = is_named(text_of_key(*it->as_table(), "name")) ? it + 1 : tables->erase(it);
  if (tables->empty()) rig.erase(key);
}

bool keep_devices(toml::table& rig, const std::vector<TwinDevice>& devices) {
  const auto before = rig["device"].as_array()->size();
  keep_named(rig, "device", [&](const std::string& name) {
    return std::ranges::find(devices, name, &TwinDevice::name) != devices.end();
  });
  return rig["device"].as_array()->size() == before;
}

}  // namespace

std::string twin_rig_text(const std::string& rig_text, const TwinRig& twin) {
  try {
    toml::table rig = toml::parse(rig_text);
    rig.erase("expect");
    rig.erase("fault");
    rename_files(rig, twin);
    auto& general = *rig["rig"].as_table();
    const auto start = toml::parse("start = " + start_text(twin.start));
    general.insert_or_assign("start", *start.get("start"));
    general.insert_or_assign("mission", "mission.toml");
    if (!keep_devices(rig, twin.devices))
      keep_named(rig, "estimator", [&](const std::string& name) {
        return std::ranges::find(twin.estimators, name) != twin.estimators.end();
      });
    for (auto& item : *rig["device"].as_array()) {
      auto& device = *item.as_table();
      const auto found =
          std::ranges::find(twin.devices, text_of_key(device, "name"), &TwinDevice::name);
      if (found != twin.devices.end()) change_device(device, *found);
    }
    std::ostringstream out;
    out << rig << '\n';
    return with_short_numbers(out.str());
  } catch (const toml::parse_error& error) {
    throw std::runtime_error("the rig file is no TOML: " + std::string(error.description()));
  }
}

}  // namespace drydock::twin

#include "estimators/external/hello.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "drivers/measurement/units.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "estimators/external/quoted.hpp"

namespace drydock::external {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson device_json(const Hello::Device& device) {
  std::array<double, 3> mounting_deg = device.mounting_rad;
  for (double& angle : mounting_deg) angle *= units::degrees_per_radian;
  return {{"name", device.name},
          {"kind", device.kind},
          {"rate_hz", device.rate_hz},
          {"lever_arm_m", device.lever_arm_m},
          {"mounting_deg", mounting_deg}};
}

}  // namespace

OrderedJson json_of(const std::vector<Hello::Device>& devices) {
  OrderedJson json = OrderedJson::array();
  for (const auto& device : devices) json.push_back(device_json(device));
  return json;
}

std::string line_of(const Hello& hello) {
  const OrderedJson json{
      {"drydock", protocol_version},
      {"rig", hello.rig},
      {"estimator", hello.estimator},
      {"gives", rig_config::external_gives_names.at(static_cast<std::size_t>(hello.gives))},
      {"step_s", hello.step_s},
      {"lockstep", hello.lockstep},
      {"devices", json_of(hello.devices)}};
  return text::json_of_any_text(json, -1);
}

std::string fault_of_hello(std::string_view line) {
  const auto json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object() || !json.contains("drydock") || !json["drydock"].is_number_integer())
    return fmt::format("answered the greeting with {} instead of {{\"drydock\":{}}}", quoted(line),
                       protocol_version);
  const auto version = json["drydock"].get<std::int64_t>();
  if (version == protocol_version) return {};
  return fmt::format("speaks version {} of the protocol, allowed: {}", version, protocol_version);
}

}  // namespace drydock::external

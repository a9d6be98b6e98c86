#include <filesystem>

#include "drivers/measurement/stamp.hpp"
#include "estimators/external/client_peer.hpp"
#include "estimators/setup/options_of.hpp"

namespace drydock::setup {
namespace {

external::Hello::Device told_device(const rig_config::DeviceConfig& device) {
  return {.name = device.name,
          .kind = std::string(measurement::to_string(device.kind)),
          .rate_hz = device.rate_hz,
          .lever_arm_m = device.lever_arm_m,
          .mounting_rad = device.mounting_rad};
}

external::Hello hello_of(const rig_config::ExternalConfig& config, const EstimatorInRig& place) {
  external::Hello hello{.rig = place.rig.name,
                        .estimator = place.estimator.name,
                        .gives = config.gives,
                        .step_s = config.step_s,
                        .lockstep = place.outside->lockstep,
                        .devices = {}};
  for (const auto& device : place.rig.devices) hello.devices.push_back(told_device(device));
  return hello;
}

external::ClientOptions client_of(const rig_config::ExternalConfig& config,
                                  const EstimatorInRig& place) {
  return {.command = config.command,
          .folder = std::filesystem::path(place.rig.file).parent_path().string(),
          .hello = hello_of(config, place),
          .answer_within = measurement::from_seconds(config.answer_within_s),
          .say = place.outside->say};
}

}  // namespace

pipeline::ExternalOptions options_of(const rig_config::ExternalConfig& config,
                                     const EstimatorInRig& place) {
  pipeline::ExternalOptions options;
  options.step = measurement::from_seconds(config.step_s);
  if (place.outside != nullptr)
    options.connect = [client = client_of(config, place)] {
      return std::make_unique<external::ClientPeer>(client);
    };
  return options;
}

}  // namespace drydock::setup

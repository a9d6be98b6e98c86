#include <filesystem>

#include "drivers/measurement/stamp.hpp"
#include "estimators/external/client_peer.hpp"
#include "estimators/external/step_topic_peer.hpp"
#include "estimators/external/topic_peer.hpp"
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

/// Where the mission begins, unless the rig says it.
frame::Position origin_of(const rig_config::ExternalConfig& config, const rig_config::Rig& rig) {
  const auto& mission = rig.mission;
  const auto origin = config.origin.value_or(
      std::array{mission.latitude_rad, mission.longitude_rad, -mission.depth_m});
  return {origin[0], origin[1], origin[2]};
}

external::TopicOptions topic_of(const rig_config::ExternalConfig& config,
                                const EstimatorInRig& place) {
  return {.estimator = place.estimator.name,
          .topic = config.topic,
          .type = static_cast<bus::OutsideType>(config.message),
          .gives = config.gives,
          .origin = origin_of(config, place.rig),
          .domain = static_cast<std::uint32_t>(place.rig.dds_domain),
          .interface = place.rig.dds_interface,
          .say = place.outside->say};
}

}  // namespace

pipeline::ExternalOptions options_of(const rig_config::ExternalConfig& config,
                                     const EstimatorInRig& place) {
  pipeline::ExternalOptions options;
  options.step = measurement::from_seconds(config.step_s);
  if (place.outside == nullptr) return options;
  if (const auto peer = place.outside->peers.find(place.estimator.name);
      peer != place.outside->peers.end())
    options.connect = peer->second;
  else if (!config.topic.empty() && place.outside->lockstep)
    options.connect = [topic = topic_of(config, place), devices = place.outside->devices,
                       within = measurement::from_seconds(config.answer_within_s)] {
      return std::make_unique<external::StepTopicPeer>(topic, devices, within);
    };
  else if (!config.topic.empty())
    options.connect = [topic = topic_of(config, place)] {
      return std::make_unique<external::TopicPeer>(topic);
    };
  else
    options.connect = [client = client_of(config, place)] {
      return std::make_unique<external::ClientPeer>(client);
    };
  return options;
}

}  // namespace drydock::setup

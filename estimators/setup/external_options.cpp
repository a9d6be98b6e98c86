#include <filesystem>

#include "drivers/measurement/stamp.hpp"
#include "estimators/external/client_peer.hpp"
#include "estimators/external/step_topic_peer.hpp"
#include "estimators/external/topic_peer.hpp"
#include "estimators/setup/options_of.hpp"
#include "estimators/setup/told_devices.hpp"

namespace drydock::setup {
namespace {

external::Hello hello_of(const rig_config::ExternalConfig& config, const EstimatorInRig& place) {
  return {.rig = place.rig.name,
          .estimator = place.estimator.name,
          .gives = config.gives,
          .step_s = config.step_s,
          .lockstep = place.outside->lockstep,
          .devices = told_devices(place.rig)};
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

#include "rig_config/estimator/leveling.hpp"

#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {

void read_kind(const Node& table, LevelingConfig& into) {
  std::string filter, model;
  read(table, "filter", filter);
  if (filter == "augmented") into.filter = LevelingFilter::augmented;
  if (filter == "paper") into.filter = LevelingFilter::paper;
  read(table, "model", model);
  into.stationary = model == "stationary";
  read(table, "log", into.log);
  into.start = read_attitude_start(table);
}

std::vector<std::string> compared_devices(const LevelingConfig& config) {
  if (config.stationary) return {};
  return {config.log};
}

}  // namespace drydock::rig_config

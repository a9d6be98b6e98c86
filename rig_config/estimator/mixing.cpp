#include "rig_config/estimator/mixing.hpp"

#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {

namespace {

constexpr std::array mixing_types{"compensated", "type1", "type2", "type3"};

}  // namespace

void read_kind(const Node& table, MixingConfig& into) {
  if (table.find("type")) into.type = named<MixingType>(table, mixing_types, "type");
  read(table, "log", into.log);
  into.start = read_attitude_start(table);
  read(table, "pivot_m", into.pivot_m);
}

std::vector<std::string> compared_devices(const MixingConfig&) { return {}; }

}  // namespace drydock::rig_config

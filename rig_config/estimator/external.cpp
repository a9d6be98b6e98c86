#include "rig_config/estimator/external.hpp"

#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {

void read_kind(const Node& table, ExternalConfig& into) {
  into.gives = named<ExternalGives>(table, external_gives_names, "gives");
  if (const Node* command = table.find("command"))
    for (const Node& word : command->items) into.command.push_back(word.text);
  read(table, "step_s", into.step_s);
  read(table, "answer_within_s", into.answer_within_s);
}

std::vector<std::string> compared_devices(const ExternalConfig&) { return {}; }

}  // namespace drydock::rig_config

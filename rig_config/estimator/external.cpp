#include "rig_config/estimator/external.hpp"

#include "drivers/measurement/units.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {

namespace {

std::array<double, 3> read_origin(const Node& table) {
  std::array<double, 3> origin{};
  read(table, "latitude_deg", origin[0], units::degree);
  read(table, "longitude_deg", origin[1], units::degree);
  read(table, "height_m", origin[2]);
  return origin;
}

}  // namespace

void read_kind(const Node& table, ExternalConfig& into) {
  into.gives = named<ExternalGives>(table, external_gives_names, "gives");
  if (const Node* command = table.find("command"))
    for (const Node& word : command->items) into.command.push_back(word.text);
  read(table, "topic", into.topic);
  if (table.find("message"))
    into.message = named<OutsideMessage>(table, outside_message_names, "message");
  if (const Node* origin = table.find("origin")) into.origin = read_origin(*origin);
  read(table, "step_s", into.step_s);
  read(table, "answer_within_s", into.answer_within_s);
}

std::vector<std::string> compared_devices(const ExternalConfig&) { return {}; }

}  // namespace drydock::rig_config

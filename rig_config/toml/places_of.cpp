#include "rig_config/toml/places_of.hpp"

namespace drydock::rig_config {

namespace {

void note(const Node& node, const std::string& path, Places& places) {
  places.at.emplace(path, std::pair(node.at.line, node.at.column));
  for (const auto& [key, value] : node.members) note(value, path + "/" + key, places);
  for (std::size_t i = 0; i < node.items.size(); ++i)
    note(node.items[i], path + "/" + std::to_string(i), places);
}

}  // namespace

PlacesPtr places_of(const Node& root, const std::string& file) {
  auto places = std::make_shared<Places>();
  places->file = file;
  note(root, "", *places);
  return places;
}

}  // namespace drydock::rig_config

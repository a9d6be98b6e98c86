#pragma once

#include <optional>

#include "drivers/wire/dvl/water_linked_json.hpp"

namespace drydock::emulate {

/// What a Water Linked DVL hears in one TCP read is one document to it, with or without line ends.
class WaterLinkedJsonDocument {
 public:
  /// Empty if it is not one JSON value. The texts of the command are valid until the next call; one
  /// that is no command has no name.
  std::optional<wire::water_linked_json::Command> read(wire::Bytes heard);

 private:
  std::array<std::uint8_t, wire::WaterLinkedJson::max_frame> text_{};
};

/// Reads the parameters of set_config. Empty if one is unknown or of another kind.
std::optional<wire::water_linked_json::Configuration> parameters_of(std::string_view object);

}  // namespace drydock::emulate

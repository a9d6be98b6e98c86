#pragma once

#include <optional>
#include <string>

#include "drivers/wire/dbc/database.hpp"
#include "drivers/wire/described/plan.hpp"
#include "rig_config/device_description/protocol_keys.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// What a field needs to know of its protocol and sensor.
struct FieldContext {
  wire::described::Form form;
  std::optional<measurement::Kind> kind;  ///< empty: of a sensor that measures nothing
  char separator;                         ///< behind a field of a text
  NumberOrder order;                      ///< unless the field says it
  std::string file, path;
  const wire::dbc::Message* message = nullptr;        ///< frames: that of the DBC file
  const std::vector<std::string>* groups = nullptr;   ///< lines: of their pattern
  const wire::described::Records* records = nullptr;  ///< binary: of which the message is made
};

/// Reads the table of one field of a message. Problems are appended; the field is then not usable.
wire::described::Field read_field(const Node& table, const FieldContext& context,
                                  Problems& problems);

/// u8, i16, f32, bcd4, ...: sets type and size. False for another name.
bool read_binary_type(std::string_view name, wire::described::Field& field);

}  // namespace drydock::rig_config

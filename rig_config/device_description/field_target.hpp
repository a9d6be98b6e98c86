#pragma once

#include "rig_config/device_description/field_reader.hpp"

namespace drydock::rig_config {

/// The word of `field` that says whether a measurement holds.
inline constexpr std::string_view valid_word = "valid";

/// The key `field` of a field's table: its target, factor and offset to SI, or its validity.
/// `unit_of_file`: of the DBC file, where the table names no unit. Problems are appended.
void read_target(const Node& table, const FieldContext& context, const std::string& unit_of_file,
                 wire::described::Field& field, Problems& problems);

/// Scale and offset of a value that no measurement has: it keeps the unit of the wire.
void scale_plainly(const Node& table, const FieldContext& context, wire::described::Field& field,
                   Problems& problems);

}  // namespace drydock::rig_config

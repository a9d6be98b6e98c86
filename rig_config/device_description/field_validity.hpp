#pragma once

#include "rig_config/device_description/field_reader.hpp"

namespace drydock::rig_config {

/// 'good', 'above' and 'bad' of a field that says whether the message's measurement holds; of
/// another field they are problems.
void read_validity(const Node& table, const FieldContext& context, wire::described::Field& field,
                   Problems& problems);

}  // namespace drydock::rig_config

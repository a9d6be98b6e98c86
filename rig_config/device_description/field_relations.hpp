#pragma once

#include "drivers/wire/described/plan.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// What the fields of one message say of each other: divisors are found; names that stand twice,
/// and a required field behind an optional one of a text or a binary frame, are problems. `tables`:
/// those of the fields, in their order.
void relate_fields(std::span<const Node> tables, bool in_order,
                   std::vector<wire::described::Field>& fields, const std::string& file,
                   const std::string& path, Problems& problems);

/// The fields that are part of a measurement, by rank.
std::vector<std::uint8_t> mapped(const std::vector<wire::described::Field>& fields);

}  // namespace drydock::rig_config

#pragma once

#include "drivers/wire/described/plan.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// The key `pattern` of a line. Null: it has none, or it was refused. Problems are appended.
std::shared_ptr<wire::described::PatternLine> read_pattern(const Node& line,
                                                           const std::string& file,
                                                           const std::string& path,
                                                           Problems& problems);

/// The key `emulate` of a line by a pattern: what an emulated device writes, with `{group}` for the
/// value of the field of that group. Problems are appended.
void read_written(const Node& line, std::span<const wire::described::Field> fields,
                  wire::described::PatternLine& into, const std::string& file,
                  const std::string& path, Problems& problems);

}  // namespace drydock::rig_config

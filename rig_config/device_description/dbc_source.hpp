#pragma once

#include <optional>
#include <span>
#include <string>

#include "drivers/wire/dbc/database.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// A file of rig_config/dbc. They are part of the program.
struct BuiltInDbc {
  std::string_view name, text;
};
std::span<const BuiltInDbc> built_in_dbcs();

/// The DBC file that `word` names: beside the description `file`, or else the one that is built in.
/// Empty after problems: the file's own mistakes, or that there is none. `read_from`: the path of a
/// file that is not built in.
std::optional<wire::dbc::Database> find_dbc(const Node& word, const std::string& file,
                                            std::string& read_from, Problems& problems);

}  // namespace drydock::rig_config

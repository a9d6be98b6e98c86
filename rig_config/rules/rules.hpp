#pragma once

#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// One end of a range.
struct Bound {
  double value = 0;
  bool exclusive = false;
};

struct Pattern {
  std::string expression, meaning;  ///< meaning: the schema's description, what a match is
};

/// All that the schema says about one place of a document, merged from its `$ref`, `allOf` and the
/// branches of `if` that the document takes. Only the words of the rig schema are understood.
struct Rules {
  std::vector<std::string> types;  ///< JSON type names, empty: any
  bool date_time = false;
  std::vector<std::string> choices;  ///< of an enum, the narrowest one
  std::optional<Bound> lower, upper;
  std::vector<Pattern> patterns;
  std::size_t min_length = 0;
  std::size_t min_items = 0, max_items = std::numeric_limits<std::size_t>::max();
  std::size_t min_members = 0;
  std::vector<std::string> required;     ///< keys
  std::vector<std::string> known;        ///< keys that the schema names here
  std::vector<std::string> allowed;      ///< of them, those that no other value forbids
  bool closed = false;                   ///< no other keys than `known`
  std::optional<std::string> forbidden;  ///< the value may not stand here: when it may
};

/// The rules for the value at `place` (keys and indices from the root) and the value itself;
/// nothing where the document has no such place.
struct Ruled {
  const Node* node = nullptr;
  Rules rules;
};
std::optional<Ruled> rules_at(const nlohmann::json& schema, const Node& root,
                              const std::vector<std::string>& place);

}  // namespace drydock::rig_config

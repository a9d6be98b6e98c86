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
  std::string expression, meaning;  ///< meaning: the schema's description of a match
};

/// All rules of the schema for one place of a document. They are merged from `$ref`, `allOf` and
/// those branches of `if` that apply to the document. It knows only the keywords of the rig schema.
struct Rules {
  std::vector<std::string> types;  ///< JSON type names, empty: any
  bool date_time = false;
  std::vector<std::string> choices;  ///< of the enum with the fewest values
  std::optional<Bound> lower, upper;
  std::vector<Pattern> patterns;
  std::size_t min_length = 0;
  std::size_t min_items = 0, max_items = std::numeric_limits<std::size_t>::max();
  std::size_t min_members = 0;
  std::vector<std::string> required;     ///< keys
  std::vector<std::string> known;        ///< keys that the schema names here
  std::vector<std::string> allowed;      ///< known keys that no other value forbids
  bool closed = false;                   ///< true: only `known` keys are valid
  std::optional<std::string> forbidden;  ///< set: not allowed here; says when it is allowed
};

/// The value at `place` (keys and indices from the root) and its rules. Empty if the document has
/// no such place.
struct Ruled {
  const Node* node = nullptr;
  Rules rules;
};
std::optional<Ruled> rules_at(const nlohmann::json& schema, const Node& root,
                              const std::vector<std::string>& place);

}  // namespace drydock::rig_config

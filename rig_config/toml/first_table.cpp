#include "rig_config/toml/first_table.hpp"

#include <array>

#include "rig_config/rules/explain.hpp"

namespace drydock::rig_config {

Problem without_first_table(const Node& root, const std::string& file, const std::string& table,
                            const std::string& what) {
  if (table.empty()) return {file, 1, 1, "/", what};
  for (const Node::Member& member : root.members)
    if (const auto meant = did_you_mean(member.key, std::array{table}); !meant.empty())
      return {file, member.value.key_at.line, member.value.key_at.column, "/" + member.key,
              what + meant};
  return {file, 1, 1, "/", what};
}

}  // namespace drydock::rig_config

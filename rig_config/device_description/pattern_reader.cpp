#include "rig_config/device_description/pattern_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rig_config/rules/explain.hpp"

namespace drydock::rig_config {

namespace described = wire::described;

std::shared_ptr<described::PatternLine> read_pattern(const Node& line, const std::string& file,
                                                     const std::string& path, Problems& problems) {
  const Node* word = line.find("pattern");
  if (!word) return nullptr;
  auto read = std::make_shared<described::PatternLine>(word->text);
  if (read->pattern.error().empty()) return read;
  problems.push_back({file, word->at.line, word->at.column, path + "/pattern",
                      "the pattern cannot be used: " + read->pattern.error()});
  return nullptr;
}

void read_written(const Node& line, std::span<const described::Field> fields,
                  described::PatternLine& into, const std::string& file, const std::string& path,
                  Problems& problems) {
  const Node* word = line.find("emulate");
  const auto& groups = into.pattern.groups();
  std::string_view rest = word ? std::string_view(word->text) : "";
  while (!rest.empty()) {
    described::WrittenPiece piece{std::string(rest.substr(0, rest.find('{')))};
    rest.remove_prefix(piece.text.size());
    if (rest.starts_with("{{")) {  // one bracket that begins no group
      piece.text += '{';
      rest.remove_prefix(2);
    } else if (!rest.empty()) {
      const auto end = std::min(rest.find('}'), rest.size());
      const std::string name(rest.substr(1, end - 1));
      const auto found =
          std::ranges::find_if(fields, [&](const auto& field) { return groups[field.at] == name; });
      if (found == fields.end())
        return problems.push_back({file, word->at.line, word->at.column, path + "/emulate",
                                   fmt::format("no field has the group \"{}\"{}, allowed: {}", name,
                                               did_you_mean(name, groups), listed(groups))});
      piece.field = static_cast<int>(found - fields.begin());
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    into.written.push_back(std::move(piece));
  }
}

}  // namespace drydock::rig_config

#include "drivers/recordings/record/message_layout.hpp"

#include <array>
#include <charconv>
#include <map>
#include <sstream>
#include <utility>

namespace drydock::record {

namespace {

constexpr std::array<std::pair<std::string_view, Scalar>, 15> scalars{{{"bool", Scalar::boolean},
                                                                       {"int8", Scalar::int8},
                                                                       {"uint8", Scalar::uint8},
                                                                       {"byte", Scalar::uint8},
                                                                       {"char", Scalar::uint8},
                                                                       {"int16", Scalar::int16},
                                                                       {"uint16", Scalar::uint16},
                                                                       {"int32", Scalar::int32},
                                                                       {"uint32", Scalar::uint32},
                                                                       {"int64", Scalar::int64},
                                                                       {"uint64", Scalar::uint64},
                                                                       {"float32", Scalar::float32},
                                                                       {"float64", Scalar::float64},
                                                                       {"string", Scalar::text},
                                                                       {"", Scalar::nested}}};

Scalar scalar_of(std::string_view type) {
  for (const auto& [name, scalar] : scalars)
    if (name == type) return scalar;
  return Scalar::nested;
}

/// Parses `type`, `type[]`, `type[<=9]`, `type[9]`, `string<=32`.
MessageNode field_of(std::string type, std::string name) {
  MessageNode field;
  field.name = std::move(name);
  if (const auto bracket = type.find('['); bracket != std::string::npos) {
    const auto [end, error] =
        std::from_chars(type.data() + bracket + 1, type.data() + type.size(), field.count);
    field.repeat =
        error == std::errc{} ? MessageNode::Repeat::array : MessageNode::Repeat::sequence;
    type.resize(bracket);
  }
  type.resize(std::min(type.size(), type.find("<=")));
  field.scalar = scalar_of(type);
  field.type = std::move(type);
  return field;
}

using Fields = std::vector<MessageNode>;

/// The fields of every message in the definition. The name of the first message is "".
std::map<std::string, Fields> fields_of(std::string_view definition) {
  std::map<std::string, Fields> messages;
  Fields* fields = &messages[""];
  std::istringstream lines{std::string(definition)};
  for (std::string line; std::getline(lines, line);) {
    line.resize(std::min(line.size(), line.find('#')));
    std::istringstream words(line);
    std::string type, name;
    if (!(words >> type >> name)) continue;
    if (type == "MSG:") {
      fields = &messages[name];
    } else if (line.find('=') == std::string::npos || line.find("<=") != std::string::npos) {
      fields->push_back(field_of(std::move(type), std::move(name)));  // otherwise it is a constant
    }
  }
  return messages;
}

/// Fills in the members of nested messages. False if one is not defined or contains itself. Nested
/// messages can double the number of fields at every level, so this number has a limit (a
/// nav_msgs/Odometry has 30). Every element must have at least one byte: only the size of the
/// message limits their number.
class Resolver {
 public:
  explicit Resolver(const std::map<std::string, Fields>& messages) : messages_(messages) {}

  bool resolve(MessageNode& node, int depth = 0) {
    constexpr int deepest = 16;
    constexpr std::size_t most_fields = 10'000;
    if (node.repeat == MessageNode::Repeat::array && node.count == 0) return false;
    if (node.scalar != Scalar::nested) return true;
    const auto found = messages_.find(node.type);
    if (found == messages_.end() || found->second.empty() || depth > deepest) return false;
    fields_ += found->second.size();
    if (fields_ > most_fields) return false;
    node.members = found->second;
    for (auto& member : node.members)
      if (!resolve(member, depth + 1)) return false;
    return true;
  }

 private:
  const std::map<std::string, Fields>& messages_;
  std::size_t fields_ = 0;
};

}  // namespace

std::optional<MessageNode> parse_definition(std::string_view definition) {
  MessageNode message;
  const auto messages = fields_of(definition);
  if (!Resolver(messages).resolve(message)) return {};
  return message;
}

}  // namespace drydock::record

#include "drivers/recordings/record/message_layout.hpp"

#include <fmt/format.h>

#include <array>
#include <boost/throw_exception.hpp>
#include <charconv>
#include <map>
#include <sstream>
#include <stdexcept>
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

/// Of a message without fields: rosidl puts this byte into it.
Fields without_fields() { return {field_of("uint8", "structure_needs_at_least_one_member")}; }

/// "nav_msgs/msg/Odometry" -> "nav_msgs/Odometry"
std::string short_name(std::string_view type) {
  const auto first = type.find('/'), last = type.rfind('/');
  if (first == last) return std::string(type);
  return std::string(type.substr(0, first)).append(type.substr(last));
}

/// The name of a type that the message `in` names.
std::string full_name(const std::string& type, std::string_view in) {
  if (type.find('/') != std::string::npos) return short_name(type);
  return std::string(in.substr(0, in.find('/') + 1)) + type;
}

/// `words` stand after a type: "NAME=1", "NAME = 1", but not "key \"a=b\"", which is a default.
bool is_constant(std::string_view words) {
  const auto name_end = std::min(words.find_first_of(" \t="), words.size());
  const auto next = words.find_first_not_of(" \t", name_end);
  return next != std::string_view::npos && words[next] == '=';
}

/// The fields of every message in the definition, by name.
std::map<std::string, Fields> fields_of(std::string_view definition, const std::string& first) {
  std::map<std::string, Fields> messages;
  Fields* fields = &messages[first];
  std::istringstream lines{std::string(definition)};
  for (std::string line; std::getline(lines, line);) {
    line.resize(std::min(line.size(), line.find('#')));
    std::istringstream words(line);
    std::string type, rest;
    if (!(words >> type)) continue;
    const bool annotated = type.starts_with('@');  // may stand on a line of its own
    if (!std::getline(words >> std::ws, rest) && !annotated) continue;
    const std::string name = rest.substr(0, rest.find_first_of(" \t\r"));
    if (type == "MSG:") {
      fields = &messages[short_name(name)];
      fields->clear();  // defined again
    } else if (annotated || !is_constant(rest)) {
      fields->push_back(field_of(std::move(type), name));
    }
  }
  return messages;
}

/// Fills in the members of nested messages. Nested messages can double the number of fields at
/// every level, so this number has a limit (a nav_msgs/Odometry has 30). Every element has at least
/// one byte: only the size of the message limits their number.
class Resolver {
 public:
  explicit Resolver(const std::map<std::string, Fields>& messages) : messages_(messages) {}

  /// Why not; empty: they are filled in.
  std::string resolve(MessageNode& node, int depth = 0) {
    constexpr int deepest = 16;
    constexpr std::size_t most_fields = 10'000;
    if (node.repeat == MessageNode::Repeat::array && node.count == 0)
      return "its definition has an array of no elements";
    if (node.scalar != Scalar::nested) return {};
    const auto found = messages_.find(node.type);
    if (found == messages_.end()) return missing(node.type);
    node.members = found->second.empty() ? without_fields() : found->second;
    fields_ += node.members.size();
    if (depth > deepest || fields_ > most_fields)
      return "its definition is nested too deeply, or has more than 10000 fields";
    for (auto& member : node.members) {
      if (member.scalar == Scalar::nested && !unread(member.type))
        member.type = full_name(member.type, node.type);
      if (auto why = resolve(member, depth + 1); !why.empty()) return why;
    }
    return {};
  }

 private:
  /// Their CDR differs between programs, or is not plain.
  static bool unread(std::string_view type) { return type == "wstring" || type.starts_with('@'); }

  static std::string missing(const std::string& type) {
    if (type.starts_with('@')) return "its definition has an " + type + " field, which is not read";
    if (unread(type)) return "its definition has a " + type + ", which is not read";
    return "its definition does not have " + type;
  }

  const std::map<std::string, Fields>& messages_;
  std::size_t fields_ = 0;
};

struct Nothing {
  void value(const MessageNode&, std::size_t, mcap::Bytes) {}
  void begin(const MessageNode&, std::size_t) {}
  void end(const MessageNode&) {}
  void enter(const MessageNode&, std::size_t) {}
  void leave(const MessageNode&) {}
};

}  // namespace

void throw_exception_from_error(const LayoutTrouble& trouble, const boost::source_location& where) {
  boost::throw_exception(std::runtime_error(trouble.line), where);
}

boost::system::result<MessageNode, LayoutTrouble> parse_definition(std::string_view definition,
                                                                   std::string_view type) {
  MessageNode message;
  message.type = short_name(type);
  const auto messages = fields_of(definition, message.type);
  if (auto why = Resolver(messages).resolve(message); !why.empty())
    return LayoutTrouble{std::move(why)};
  return message;
}

std::string misfit(const MessageNode& message, mcap::Bytes cdr) {
  if (visit_message(message, cdr, Nothing{})) return {};
  if (cdr.size() >= 4 && (cdr[0] != 0 || cdr[1] != 1))
    return fmt::format(
        "its CDR begins with {:02X} {:02X}, and only plain CDR, little endian (00 01) is read",
        cdr[0], cdr[1]);
  return "it ends before its definition does";
}

}  // namespace drydock::record

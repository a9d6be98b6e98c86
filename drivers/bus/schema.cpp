#include "drivers/bus/schema.hpp"

#include <array>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "drivers/bus/idl_text.hpp"

namespace drydock::bus {

namespace {

struct Field {
  std::string type;  ///< as in .msg files; "package/Type" for another message
  std::string rest;  ///< "[]", "[9]" or nothing, a space and the name
};
using Fields = std::vector<Field>;

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> primitives{
    {{"double", "float64"},
     {"float", "float32"},
     {"octet", "byte"},
     {"boolean", "bool"},
     {"uint8", "uint8"}}};

std::string without(std::string text, std::string_view part) {
  if (const auto at = text.find(part); at != std::string::npos) text.erase(at, part.size());
  return text;
}

/// "std_msgs::msg::dds_::Header_" -> "std_msgs/Header". A name without a scope belongs to
/// `package`.
std::string message_name(std::string idl, const std::string& package) {
  constexpr std::string_view scope = "::msg::dds_::";
  idl.pop_back();
  const auto at = idl.find(scope);
  if (at == std::string::npos) return package + "/" + idl;
  return idl.substr(0, at) + "/" + idl.substr(at + scope.size());
}

std::string msg_type(const std::string& idl, const std::string& package) {
  for (const auto& [from, to] : primitives)
    if (idl == from) return std::string(to);
  return idl.back() == '_' ? message_name(idl, package) : idl;
}

/// Parses a line of a struct: `type name;`, `type name[9];` or `sequence<type> name;`.
Field field_of(std::string type, std::string name, const std::string& package) {
  name.pop_back();
  std::string array;
  if (type.starts_with("sequence<")) {
    type = without(without(type, "sequence<"), ">");
    array = "[]";
  } else if (const auto bracket = name.find('['); bracket != std::string::npos) {
    array = name.substr(bracket);
    name.resize(bracket);
  }
  return {msg_type(type, package), array + " " + name};
}

/// Every struct of the IDL files. The files have one field on each line.
std::map<std::string, Fields> read_idl() {
  std::map<std::string, Fields> messages;
  std::istringstream lines{std::string(idl_text())};
  std::string line, package;
  Fields* fields = nullptr;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::vector<std::string> word{std::istream_iterator<std::string>(words), {}};
    if (word.empty() || word[0].starts_with("//") || word[0].starts_with("#")) continue;
    if (word[0] == "module") {
      package = word[1];
    } else if (word[0].starts_with("@") && word.size() >= 3) {
      fields = &messages[message_name(word[word.size() - 2], package)];
    } else if (word[0].starts_with("}")) {
      fields = nullptr;
    } else if (fields != nullptr && word.size() >= 2) {
      fields->push_back(field_of(word[0], word[1], package));
    }
  }
  return messages;
}

const std::map<std::string, Fields>& messages() {
  static const auto all = read_idl();
  return all;
}

void define(const std::string& name, std::string& text, std::vector<std::string>& needed) {
  const auto found = messages().find(name);
  if (found == messages().end()) throw std::invalid_argument("no message type " + name);
  for (const auto& [type, rest] : found->second) {
    text += type + rest + "\n";
    if (type.find('/') != std::string::npos) needed.push_back(type);
  }
}

}  // namespace

std::string ros2_type(std::string_view dds_type) {
  std::string name(dds_type);
  for (std::size_t at; (at = name.find("::")) != std::string::npos;) name.replace(at, 2, "/");
  name = without(name, "dds_/");
  name.pop_back();
  return name;
}

std::string ros2_schema(std::string_view ros2_type) {
  std::string text;
  std::vector<std::string> needed;
  std::set<std::string> defined;
  define(without(std::string(ros2_type), "msg/"), text, needed);
  for (std::size_t i = 0; i < needed.size(); ++i) {
    const std::string name = needed[i];
    if (!defined.insert(name).second) continue;
    text.append(80, '=').append("\nMSG: ").append(name).append("\n");
    define(name, text, needed);
  }
  return text;
}

}  // namespace drydock::bus

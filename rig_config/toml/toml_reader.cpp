#include "rig_config/toml/toml_reader.hpp"

#include <toml++/toml.h>

#include <cmath>
#include <sstream>

#include "rig_config/toml/syntax_advice.hpp"
#include "rig_config/toml/toml_limits.hpp"

namespace drydock::rig_config {

namespace {

/// Longest key and text. Patterns are matched by a recursion with one step for each character.
constexpr std::size_t longest_key = 128, longest_text = 4096;
/// With this limit a number stays finite after the conversion of its unit.
constexpr double largest_number = 1e18;
constexpr int last_year = 2200;  ///< nanoseconds since 1970 overflow in 2262

Position position(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

/// Nanoseconds since 1970, in the proleptic Gregorian calendar.
std::int64_t utc_ns(const toml::date_time& when) {
  const std::chrono::sys_days days{std::chrono::year{when.date.year} / when.date.month /
                                   when.date.day};
  const std::int64_t minutes = std::int64_t{when.time.hour} * 60 + when.time.minute -
                               (when.offset ? when.offset->minutes : 0);
  const std::int64_t day_seconds = minutes * 60 + when.time.second;
  return (days.time_since_epoch().count() * 86400LL + day_seconds) * 1'000'000'000 +
         when.time.nanosecond;
}

class Converter {
 public:
  explicit Converter(const std::string& file) : file_(file) {}

  Node convert(const toml::node& value, Position key_at, const std::string& path) {
    Node node;
    node.at = position(value.source());
    if (node.at.line == 0) node.at = key_at;  // a table that exists only by dotted keys
    node.key_at = key_at.line ? key_at : node.at;
    value.visit([&](const auto& v) { fill(node, v, path); });
    return node;
  }

  Problems problems;

 private:
  void fill(Node& node, const toml::table& table, const std::string& path) {
    node.kind = Node::Kind::table;
    for (auto&& [key, value] : table) {
      const std::string name{key.str()};
      if (name.size() > longest_key) {
        refuse(node, path, "a key of more than 128 characters");
        continue;
      }
      node.members.push_back({name, convert(value, position(key.source()), path + "/" + name)});
    }
  }
  void fill(Node& node, const toml::array& array, const std::string& path) {
    node.kind = Node::Kind::array;
    for (std::size_t i = 0; i < array.size(); ++i)
      node.items.push_back(convert(array[i], {}, path + "/" + std::to_string(i)));
  }
  void fill(Node& node, const toml::value<bool>& value, const std::string&) {
    node.kind = Node::Kind::boolean;
    node.boolean = value.get();
  }
  void fill(Node& node, const toml::value<std::int64_t>& value, const std::string&) {
    node.kind = Node::Kind::integer;
    node.integer = value.get();
    node.number = static_cast<double>(value.get());
  }
  void fill(Node& node, const toml::value<double>& value, const std::string& path) {
    node.kind = Node::Kind::number;
    node.number = value.get();
    if (!std::isfinite(node.number))
      refuse(node, path, "nan and inf are not allowed");
    else if (std::abs(node.number) > largest_number)
      refuse(node, path, "out of range, allowed: -1e18 to 1e18");
  }
  void fill(Node& node, const toml::value<std::string>& value, const std::string& path) {
    node.kind = Node::Kind::text;
    node.text = value.get();
    if (node.text.size() > longest_text)
      refuse(node, path,
             "a text of " + std::to_string(node.text.size()) + " characters, allowed: up to 4096");
  }
  void fill(Node& node, const toml::value<toml::date_time>& value, const std::string& path) {
    node.kind = Node::Kind::date_time;
    node.text = written(value);
    if (value.get().date.year < 1970 || value.get().date.year > last_year)
      return refuse(node, path, node.text + " is out of range, allowed: the years 1970 to 2200");
    node.integer = utc_ns(value.get());
    if (!value.get().offset)
      refuse(node, path, "this date-time has no offset, write for example " + node.text + "Z");
  }
  template <class DateOrTime>
  void fill(Node& node, const toml::value<DateOrTime>& value, const std::string& path) {
    node.kind = Node::Kind::date_time;
    node.text = written(value);
    refuse(node, path,
           "expected a full date-time such as 2026-11-21T08:00:00Z, found " + node.text);
  }

  template <class T>
  static std::string written(const toml::value<T>& value) {
    std::ostringstream text;
    text << value.get();
    return text.str();
  }
  void refuse(const Node& node, const std::string& path, std::string what) {
    problems.push_back({file_, node.at.line, node.at.column, path, std::move(what)});
  }

  const std::string& file_;
};

/// The n-th line, from 1; empty where there is none.
std::string_view line_of(std::string_view text, int n) {
  for (; n > 1; --n) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

}  // namespace

Loaded<Node> read_toml(std::string_view text, const std::string& path) {
  if (const auto problem = beyond_limits(text, path)) return Problems{*problem};
  try {
    const toml::table table = toml::parse(text, path);
    Converter converter{path};
    Node root = converter.convert(table, {1, 1}, "");
    if (!converter.problems.empty()) return converter.problems;
    return root;
  } catch (const toml::parse_error& error) {
    const Position at = position(error.source());
    const auto what = error.description();
    return Problems{{path, at.line, at.column, "/",
                     std::string{what} + syntax_advice(what, line_of(text, at.line))}};
  }
}

}  // namespace drydock::rig_config

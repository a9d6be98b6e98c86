#include "rig_config/rules/explain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <regex>

#include "rig_config/rules/other_names.hpp"

namespace drydock::rig_config {

namespace {

using Kind = Node::Kind;

std::string_view kind_in_words(Kind kind) {
  switch (kind) {
    case Kind::boolean: return "true or false";
    case Kind::integer: return "an integer";
    case Kind::number: return "a number";
    case Kind::text: return "a string";
    case Kind::date_time: return "a date-time";
    case Kind::array: return "an array";
    case Kind::table: return "a table";
  }
  return "";
}

Kind kind_of(std::string_view json_type) {
  if (json_type == "boolean") return Kind::boolean;
  if (json_type == "integer") return Kind::integer;
  if (json_type == "number") return Kind::number;
  if (json_type == "array") return Kind::array;
  return json_type == "object" ? Kind::table : Kind::text;
}

bool is_number(Kind kind) { return kind == Kind::integer || kind == Kind::number; }

std::string expected_type(const Rules& rules) {
  if (rules.date_time) return "a date-time without quotes such as 2026-11-21T08:00:00Z";
  std::string text;
  for (const std::string& type : rules.types)
    text += fmt::format("{}{}", text.empty() ? "" : " or ", kind_in_words(kind_of(type)));
  return text;
}

bool has_right_type(const Rules& rules, Kind kind) {
  if (rules.types.empty()) return true;
  if (rules.date_time || kind == Kind::date_time) return rules.date_time && kind == Kind::date_time;
  return std::ranges::any_of(rules.types, [&](const std::string& type) {
    const Kind wanted = kind_of(type);
    return wanted == kind || (wanted == Kind::number && kind == Kind::integer);
  });
}

std::string range(const Rules& rules) {
  const auto& [lower, upper] = std::tie(rules.lower, rules.upper);
  if (lower && upper && !lower->exclusive)
    return fmt::format("{} to {}", lower->value, upper->value);
  if (lower && upper) return fmt::format("above {}, up to {}", lower->value, upper->value);
  if (lower)
    return fmt::format("{}{}", lower->exclusive ? "above " : "", lower->value) +
           (lower->exclusive ? "" : " or more");
  return fmt::format("up to {}", upper->value);
}

bool in_range(const Rules& rules, double value) {
  if (rules.lower &&
      (value < rules.lower->value || (rules.lower->exclusive && value == rules.lower->value)))
    return false;
  return !rules.upper || value <= rules.upper->value;
}

std::string in_lower_case(std::string word) {
  for (char& c : word)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return word;
}

/// Letters to insert, delete, change or swap with the next one (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      row[j + 1] = std::min({last[j] + (a[i] != b[j]), last[j + 1] + 1, row[j] + 1});
      if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j])
        row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
    }
  }
  return row.back();
}

/// The letters of the word, in its order, and others between them.
bool has_letters_of(std::string_view word, std::string_view name) {
  for (const char c : name)
    if (!word.empty() && word.front() == c) word.remove_prefix(1);
  return word.empty();
}

/// The first name that the word begins up to an underscore, or else the only one that it begins at
/// all. None: null.
const std::string* begun_by(const std::string& lower, std::span<const std::string> known) {
  constexpr std::size_t long_enough = 3;  // fewer letters begin too much
  const std::string* begun = nullptr;
  std::size_t count = 0;
  for (const std::string& name : known) {
    const auto other = in_lower_case(name);
    if (other.starts_with(lower + "_")) return &name;
    if (!other.starts_with(lower)) continue;
    begun = &name;
    ++count;
  }
  return count == 1 && lower.size() >= long_enough ? begun : nullptr;
}

std::string meant(const std::string& word) { return fmt::format(" (did you mean '{}'?)", word); }

class Explanation {
 public:
  Explanation(const Ruled& ruled, const std::string& file, const std::string& path)
      : node_(*ruled.node), rules_(ruled.rules), file_(file), path_(path) {}

  Problems run() {
    if (rules_.forbidden) {
      add(node_.key_at, path_, fmt::format("not allowed here, {}", *rules_.forbidden));
    } else if (!has_right_type(rules_, node_.kind)) {
      add(node_.at, path_,
          fmt::format("expected {}, found {}{}", expected_type(rules_), kind_in_words(node_.kind),
                      two_brackets()));
    } else {
      choice();
      number();
      text();
      size();
      keys();
    }
    return std::move(problems_);
  }

 private:
  /// One pair of brackets makes a table, two an entry of a list of them.
  std::string two_brackets() const {
    const bool top_level = path_.rfind('/') == 0;
    const bool wants_list = rules_.types == std::vector<std::string>{"array"};
    if (!top_level || !wants_list || node_.kind != Kind::table) return "";
    return fmt::format("; write [[{0}]] in the place of [{0}]", path_.substr(1));
  }
  void choice() {
    if (rules_.choices.empty()) return;
    if (node_.kind != Kind::text)
      return add(node_.at, path_,
                 fmt::format("expected one of: {}, found {}", listed(rules_.choices),
                             kind_in_words(node_.kind)));
    if (std::ranges::find(rules_.choices, node_.text) != rules_.choices.end()) return;
    add(node_.at, path_,
        fmt::format("\"{}\" is not allowed{}, allowed: {}", node_.text,
                    did_you_mean(node_.text, rules_.choices), listed(rules_.choices)));
  }
  void number() {
    if (is_number(node_.kind) && !in_range(rules_, node_.number))
      add(node_.at, path_,
          fmt::format("{} is out of range, allowed: {}", node_.number, range(rules_)));
  }
  void text() {
    if (node_.kind != Kind::text) return;
    if (node_.text.size() < rules_.min_length) return add(node_.at, path_, "must not be empty");
    for (const Pattern& pattern : rules_.patterns)
      if (!std::regex_search(node_.text, std::regex(pattern.expression)))
        add(node_.at, path_, fmt::format("\"{}\" is not {}", node_.text, pattern.meaning));
  }
  void size() {
    if (node_.kind != Kind::array) return;
    const std::size_t n = node_.items.size();
    if (n < rules_.min_items || n > rules_.max_items)
      add(node_.at, path_,
          fmt::format("has {} values, allowed: {}{}", n, rules_.min_items, size_to()));
  }
  std::string size_to() const {
    if (rules_.min_items == rules_.max_items) return "";
    const bool open = rules_.max_items == std::numeric_limits<std::size_t>::max();
    return open ? " or more" : fmt::format(" to {}", rules_.max_items);
  }
  void keys() {
    if (node_.kind != Kind::table) return;
    if (node_.members.size() < rules_.min_members)
      add(node_.at, path_, fmt::format("is empty, allowed here: {}", listed(rules_.allowed)));
    for (const std::string& key : rules_.required)
      if (!node_.find(key)) add(node_.at, path_, fmt::format("key '{}' is missing", key));
    if (!rules_.closed) return;
    for (const auto& [key, value] : node_.members)
      if (std::ranges::find(rules_.known, key) == rules_.known.end()) unknown(key, value);
  }
  void unknown(const std::string& key, const Node& value) {
    add(value.key_at, path_ == "/" ? path_ + key : path_ + "/" + key,
        fmt::format("unknown key{}, allowed here: {}", did_you_mean(key, rules_.allowed),
                    listed(rules_.allowed)));
  }
  void add(Position at, const std::string& path, std::string what) {
    problems_.push_back({file_, at.line, at.column, path, std::move(what)});
  }

  const Node& node_;
  const Rules& rules_;
  const std::string& file_;
  const std::string& path_;
  Problems problems_;
};

}  // namespace

Problems explain(const Ruled& ruled, const std::string& file, const std::string& path) {
  return Explanation(ruled, file, path).run();
}

std::string did_you_mean(const std::string& word, std::span<const std::string> known) {
  const auto distance = [lower = in_lower_case(word)](const std::string& other) {
    return edit_distance(lower, in_lower_case(other));
  };
  // Who leaves out a letter is more common than who mistakes one: `sped` is `speed`, not `seed`.
  const auto rank = [&](const std::string& other) {
    return std::pair(distance(other), !has_letters_of(in_lower_case(word), other));
  };
  const auto nearest = std::ranges::min_element(known, {}, rank);
  if (nearest != known.end() && distance(*nearest) <= 1) return meant(*nearest);
  if (const auto* other = other_name_of(in_lower_case(word), known)) return meant(*other);
  if (const auto* longer = begun_by(in_lower_case(word), known)) return meant(*longer);
  if (nearest == known.end() || distance(*nearest) > 1 + word.size() / 4) return "";
  return meant(*nearest);
}

std::string listed(std::span<const std::string> words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace drydock::rig_config

#include "hil/diff/differences.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace drydock::diff {
namespace {

/// A list of the summary, how a person calls one of it, and the keys that make it the same one.
struct List {
  std::string_view key, one;
  std::array<std::string_view, 3> identity;
};
constexpr std::array lists{List{"devices", "device", {"name"}},
                           List{"estimators", "estimator", {"name"}},
                           List{"expectations", "expectation", {"of", "what"}},
                           List{"faults", "fault", {"device", "fault", "since_s"}},
                           List{"findings", "finding", {"device", "cause", "since_s"}}};
constexpr std::array of_the_computer{"wall_s", "times_real_time", "resident"};

/// Every value of a summary by its name, in the order of the file.
class Values {
 public:
  explicit Values(const Json& summary) {
    for (const auto& [key, value] : summary.items()) {
      const auto list = std::ranges::find(lists, key, &List::key);
      if (std::ranges::find(of_the_computer, key) != of_the_computer.end()) continue;
      if (list != lists.end() && value.is_array())
        add_list(*list, value);
      else
        add(key, ": ", value);
    }
  }

  const std::vector<std::string>& names() const { return names_; }
  const Json* of(const std::string& name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? nullptr : &found->second;
  }

 private:
  void add_list(const List& list, const Json& entries) {
    for (const auto& entry : entries) {
      std::string name{list.one};
      for (const auto key : list.identity)
        if (!key.empty() && entry.is_object() && entry.contains(key))
          name += " " + text_of(entry[std::string(key)]);
      add(name, ": ", entry);
    }
  }
  void add(const std::string& name, const char* separator, const Json& value) {
    if (value.is_object()) {
      for (const auto& [key, part] : value.items()) add(name + separator + key, " ", part);
    } else if (value.is_array()) {
      for (const auto& entry : value) put(name + " " + text_of(entry), true);
    } else {
      put(name, value);
    }
  }
  /// A second one of the same name gets a number.
  void put(std::string name, const Json& value) {
    const std::string first = name;
    for (int i = 2; values_.contains(name); ++i) name = first + " (" + std::to_string(i) + ")";
    names_.push_back(name);
    values_.emplace(std::move(name), value);
  }
  static std::string text_of(const Json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
  }

  std::vector<std::string> names_;
  std::map<std::string, Json> values_;
};

bool are_same(const Json& a, const Json& b, double tolerance) {
  if (!a.is_number() || !b.is_number()) return a == b;
  const double x = a, y = b;
  return std::abs(x - y) <= tolerance * std::max(std::abs(x), std::abs(y));
}

std::optional<Json> copy_of(const Json* value) {
  return value == nullptr ? std::nullopt : std::optional(*value);
}

}  // namespace

Comparison compare(const Json& a, const Json& b, double tolerance) {
  const Values of_a(a), of_b(b);
  std::vector<std::string> names = of_a.names();
  for (const auto& name : of_b.names())
    if (of_a.of(name) == nullptr) names.push_back(name);
  Comparison comparison;
  comparison.compared = names.size();
  for (const auto& name : names) {
    const Json *in_a = of_a.of(name), *in_b = of_b.of(name);
    if (in_a && in_b && are_same(*in_a, *in_b, tolerance)) continue;
    Difference difference{name, copy_of(in_a), copy_of(in_b), {}};
    if (in_a && in_b && in_a->is_number() && in_b->is_number())
      difference.change = in_b->get<double>() - in_a->get<double>();
    comparison.differences.push_back(std::move(difference));
  }
  return comparison;
}

}  // namespace drydock::diff

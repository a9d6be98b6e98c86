#include "hil/diff/differences.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "drivers/text/json_of_any_text.hpp"

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
  /// The device, estimator, ... that the value belongs to; the value's own name if it has none.
  const std::string& owner_of(const std::string& name) const { return owners_.at(name); }
  bool owns(const std::string& owner) const { return owned_.contains(owner); }
  const Json* of(const std::string& name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? nullptr : &found->second;
  }

 private:
  void add_list(const List& list, const Json& entries) {
    for (const auto& entry : entries) {
      std::string name{list.one};  // grows to "device dvl"
      for (const auto key : list.identity)
        if (!key.empty() && entry.is_object() && entry.contains(key))
          name += " " + text_of(entry[std::string(key)]);
      const std::string first = name;
      for (int i = 2; owned_.contains(name); ++i) name = first + " (" + std::to_string(i) + ")";
      owned_.insert(owner_ = name);
      add(name, ": ", entry);
      owner_.clear();
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
  void put(const std::string& name, const Json& value) {
    if (!values_.emplace(name, value).second) return;  // the same note twice
    names_.push_back(name);
    owners_.emplace(name, owner_.empty() ? name : owner_);
    owned_.insert(owners_.at(name));
  }
  static std::string text_of(const Json& value) {
    return value.is_string() ? value.get<std::string>() : text::json_of_any_text(value, -1);
  }

  std::vector<std::string> names_;
  std::map<std::string, Json> values_;
  std::map<std::string, std::string> owners_;
  std::set<std::string> owned_;
  std::string owner_;  ///< of what is being added
};

/// Verdicts have their numbers as texts.
std::optional<double> number_in(const Json& value) {
  if (value.is_number()) return value.get<double>();
  if (!value.is_string()) return {};
  const auto& text = value.get_ref<const std::string&>();
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return number;
}

std::optional<Difference> difference(const std::string& name, const Json& a, const Json& b,
                                     double tolerance) {
  if (a == b) return {};
  const auto x = number_in(a), y = number_in(b);
  if (!x || !y) return Difference{name, a, b, {}};
  if (std::abs(*x - *y) <= tolerance * std::max(std::abs(*x), std::abs(*y))) return {};
  return Difference{name, a, b, *y - *x};
}

/// Adds a line for each owner of `has` that `lacks` does not have, and the values that it lacks.
void add_absent(const Values& has, const Values& lacks, std::optional<Json> Difference::*side,
                std::vector<Difference>& differences) {
  std::set<std::string> told;
  for (const auto& name : has.names()) {
    if (lacks.of(name) != nullptr) continue;
    const auto& owner = has.owner_of(name);
    const bool whole = !lacks.owns(owner) && owner != name;
    if (!told.insert(whole ? owner : name).second) continue;
    Difference one{whole ? owner : name, {}, {}, {}};
    one.*side = whole ? Json("present") : *has.of(name);
    differences.push_back(std::move(one));
  }
}

}  // namespace

Comparison compare(const Json& a, const Json& b, double tolerance) {
  const Values of_a(a), of_b(b);
  Comparison comparison;
  for (const auto& name : of_a.names()) {
    const auto* other = of_b.of(name);
    if (other == nullptr) continue;
    ++comparison.compared;
    if (auto found = difference(name, *of_a.of(name), *other, tolerance))
      comparison.differences.push_back(std::move(*found));
  }
  add_absent(of_a, of_b, &Difference::a, comparison.differences);
  add_absent(of_b, of_a, &Difference::b, comparison.differences);
  return comparison;
}

}  // namespace drydock::diff

#include <fmt/format.h>

#include <algorithm>

#include "rig_config/checks/checks.hpp"
#include "rig_config/estimator/kinds.hpp"
#include "rig_config/rules/explain.hpp"

namespace drydock::rig_config {

namespace {

/// A figure that only some kinds of estimators have, and the fact that gives it to them.
struct FigureOfSome {
  std::string_view key;
  bool EstimatorFacts::*has;
};

constexpr auto figures_of_some =
    std::to_array<FigureOfSome>({{"heading_rms_deg_max", &EstimatorFacts::gives_positions},
                                 {"position_rms_m_max", &EstimatorFacts::gives_positions},
                                 {"position_end_m_max", &EstimatorFacts::gives_positions},
                                 {"depth_rms_m_max", &EstimatorFacts::gives_positions},
                                 {"velocity_rms_mps_max", &EstimatorFacts::gives_positions},
                                 {"nees_position", &EstimatorFacts::gives_positions},
                                 {"rejected_max", &EstimatorFacts::has_gate},
                                 {"nis", &EstimatorFacts::has_innovations}});

std::vector<std::string> kinds_with(bool EstimatorFacts::*has) {
  std::vector<std::string> kinds;
  for (const EstimatorFacts& facts : estimator_facts)
    if (facts.*has) kinds.emplace_back(facts.name);
  return kinds;
}

class ExpectChecks {
 public:
  ExpectChecks(const Node& root, const std::string& file) : root_(root), file_(file) {}

  Problems run() {
    for_each_table(root_, "expect", [&](const Node& expect, std::size_t i) {
      path_ = fmt::format("/expect/{}", i);
      is_named(expect, "device");
      is_named(expect, "estimator");
      expects_something(expect);
      bounds_are_in_order(expect);
      figures_fit_the_kind(expect);
    });
    return std::move(problems_);
  }

 private:
  void is_named(const Node& expect, const char* group) {
    const Node* wanted = expect.find_text(group);
    if (!wanted) return;
    std::vector<std::string> names;
    for_each_table(root_, group, [&](const Node& table, std::size_t) {
      if (const Node* name = table.find_text("name")) names.push_back(name->text);
    });
    if (std::ranges::find(names, wanted->text) != names.end()) return;
    const std::string offer =
        names.empty() ? fmt::format("this rig has no {}", group) : "allowed: " + listed(names);
    add(wanted->at, group,
        fmt::format("no {} is named \"{}\"{}, {}", group, wanted->text,
                    did_you_mean(wanted->text, names), offer));
  }

  void expects_something(const Node& expect) {
    const auto names_or_times = [](const Node::Member& member) {
      return member.key == "device" || member.key == "estimator" || member.key == "after_s";
    };
    if (!std::ranges::all_of(expect.members, names_or_times)) return;
    problems_.push_back({file_, expect.at.line, expect.at.column, path_,
                         "expects nothing; give at least one key such as state or nees"});
  }

  void bounds_are_in_order(const Node& expect) {
    for (const auto& [key, value] : expect.members) {
      if (value.items.size() != 2 || value.items[0].number <= value.items[1].number) continue;
      add(value.at, key,
          fmt::format("no number is from {} to {}: the lower bound stands first",
                      value.items[0].number, value.items[1].number));
    }
  }

  void figures_fit_the_kind(const Node& expect) {
    const Node* wanted = expect.find_text("estimator");
    if (!wanted) return;
    for_each_table(root_, "estimator", [&](const Node& table, std::size_t) {
      const Node* name = table.find_text("name");
      const Node* kind = table.find_text("kind");
      if (!name || !kind || name->text != wanted->text) return;
      const EstimatorFacts* facts = facts_named(kind->text);
      for (const auto& [key, has] : figures_of_some) {
        const Node* value = expect.find(key);
        if (!value || (facts && facts->*has)) continue;
        add(value->key_at, std::string(key),
            fmt::format("estimator \"{}\" is of kind {}, allowed: {}", name->text, kind->text,
                        listed(kinds_with(has))));
      }
    });
  }

  void add(Position at, const std::string& key, std::string what) {
    problems_.push_back({file_, at.line, at.column, path_ + "/" + key, std::move(what)});
  }

  const Node& root_;
  const std::string& file_;
  std::string path_;
  Problems problems_;
};

}  // namespace

Problems check_expects(const Node& root, const std::string& file) {
  return ExpectChecks(root, file).run();
}

}  // namespace drydock::rig_config

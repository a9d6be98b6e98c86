#include "tests/conformance/score.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::conformance {

void Comparison::differ(std::string_view field, const json& ours, const json& theirs) {
  differences_.push_back({file_, message_, std::string(field), ours.dump(), theirs.dump()});
}

void Comparison::number(std::string_view field, const json& ours, const json& theirs, Step step) {
  if (!ours.is_number() || !theirs.is_number()) {
    if (!ours.is_null() || !theirs.is_null()) differ(field, ours, theirs);
    return;
  }
  const double error = std::abs(ours.get<double>() - theirs.get<double>());
  FieldError& entry = errors_[std::string(field)];
  entry = {std::max(entry.largest, error), step.resolution};
  const double allowed = step.resolution / 2 + step.relative * std::abs(theirs.get<double>());
  if (!(error <= allowed)) differ(field, ours, theirs);
}

void Comparison::same(std::string_view field, const json& ours, const json& theirs) {
  if (ours != theirs) differ(field, ours, theirs);
}

void Score::add(const Comparison& comparison) {
  ++counts_.expected;
  for (const auto& [name, error] : comparison.errors_) {
    FieldError& entry = fields_[name];
    entry = {std::max(entry.largest, error.largest), error.resolution};
  }
  if (!comparison.agrees()) {
    ++counts_.wrong;
    differences_.insert(differences_.end(), comparison.differences_.begin(),
                        comparison.differences_.end());
    return;
  }
  ++counts_.matched;
  ++counts_.by_value;
  counts_.by_rule += !comparison.rules_.empty();
  for (const Rule& rule : comparison.rules_) use(rule);
}

void Score::matched(std::uint64_t count) {
  counts_.expected += count;
  counts_.matched += count;
}

void Score::missed(const std::string& file, std::size_t message, std::string_view theirs) {
  ++counts_.expected;
  ++counts_.missed;
  differences_.push_back({file, message, "message", "missed", std::string(theirs)});
}

void Score::unexpected(const std::string& file, std::size_t message, std::string_view ours) {
  ++counts_.wrong;
  differences_.push_back({file, message, "message", std::string(ours), "none"});
}

void Score::excused(const Rule& rule) {
  ++counts_.expected;
  ++counts_.matched;
  ++counts_.by_rule;
  use(rule);
}

void Score::use(const Rule& rule) {
  RuleUse& entry = rules_[std::string(rule.name)];
  entry.reason = rule.reason;
  ++entry.messages;
}

}  // namespace drydock::conformance

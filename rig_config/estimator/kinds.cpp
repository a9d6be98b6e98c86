#include "rig_config/estimator/kinds.hpp"

#include <algorithm>
#include <utility>

#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

namespace {

template <std::size_t... Index>
EstimatorKind kind_at(std::size_t index, std::index_sequence<Index...>) {
  EstimatorKind kind;
  ((Index == index ? static_cast<void>(kind.emplace<Index>()) : void()), ...);
  return kind;
}

}  // namespace

const EstimatorFacts* facts_named(std::string_view name) {
  const auto found = std::ranges::find(estimator_facts, name, &EstimatorFacts::name);
  return found == estimator_facts.end() ? nullptr : &*found;
}

EstimatorKind read_estimator_kind(const Node& table) {
  const auto index = facts_named(table.find("kind")->text) - estimator_facts.data();
  EstimatorKind kind =
      kind_at(static_cast<std::size_t>(index), std::make_index_sequence<estimator_facts.size()>{});
  std::visit([&](auto& of_kind) { read_kind(table, of_kind); }, kind);
  return kind;
}

const EstimatorFacts& facts_of(const EstimatorKind& kind) {
  const auto* external = std::get_if<ExternalConfig>(&kind);
  return external != nullptr ? external->own_facts() : estimator_facts.at(kind.index());
}

std::vector<std::string> devices_compared_by(const EstimatorKind& kind) {
  return std::visit([](const auto& of_kind) { return compared_devices(of_kind); }, kind);
}

}  // namespace drydock::rig_config

#include <fmt/format.h>

#include <array>

#include "rig_config/device_description/plan_reader.hpp"

namespace drydock::rig_config {
namespace {

namespace described = wire::described;
using described::Plan;
using enum described::Target;

constexpr std::array components{force_x, force_y, force_z, rate_x, rate_y, rate_z};

/// The first message of the sample in which each message takes part.
std::vector<std::size_t> first_of(const Plan& plan) {
  std::vector<std::size_t> first(plan.messages.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    const auto& follows = plan.messages[i].follows;
    first[i] = follows ? first[*follows] : i;
  }
  return first;
}

/// Bits of the components that a message measures.
unsigned measured(const Plan& plan, std::size_t message) {
  unsigned bits = 0;
  for (const auto& field : plan.fields_of(plan.messages[message]))
    for (std::size_t i = 0; i < components.size(); ++i)
      if (field.target == components[i]) bits |= 1u << i;
  return bits;
}

}  // namespace

Problems check_imu(const Plan& plan, std::span<const Node> tables, const std::string& file,
                   const std::string& path) {
  constexpr unsigned all = (1u << components.size()) - 1;
  const auto first = first_of(plan);
  Problems problems;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] != i) continue;
    unsigned bits = 0;
    for (std::size_t j = i; j < first.size(); ++j)
      if (first[j] == i) bits |= measured(plan, j);
    std::string missing;
    for (std::size_t k = 0; k < components.size(); ++k)
      if ((bits >> k & 1) == 0) missing += fmt::format(" {}", row_of(components[k]).name);
    if (bits != 0 && bits != all)
      problems.push_back({file, tables[i].at.line, tables[i].at.column,
                          fmt::format("{}/{}", path, i),
                          fmt::format("a sample of an IMU has three forces and three rates; this "
                                      "one lacks{}; messages with one 'sample' make one",
                                      missing)});
  }
  return problems;
}

}  // namespace drydock::rig_config

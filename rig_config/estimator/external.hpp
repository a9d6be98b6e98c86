#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rig_config/estimator/facts.hpp"

namespace drydock::rig_config {

struct Node;

/// What each of its estimates has.
enum class ExternalGives : std::uint8_t { attitude, navigation, velocity };
inline constexpr std::array external_gives_names{"attitude", "navigation", "velocity"};

/// An estimator in another program. docs/build/external-estimator.md
struct ExternalConfig {
  static constexpr EstimatorFacts facts{.name = "external", .devices = {}, .gives_positions = true};
  static constexpr EstimatorFacts attitude_facts{.name = facts.name, .devices = {}};

  /// One that gives attitudes alone has no topic of positions.
  const EstimatorFacts& own_facts() const {
    return gives == ExternalGives::attitude ? attitude_facts : facts;
  }

  std::vector<std::string> command;  ///< the program and its arguments
  ExternalGives gives = ExternalGives::attitude;
  double step_s = 0.05;
  double answer_within_s = 2;
};

void read_kind(const Node& table, ExternalConfig& into);

/// None: the other program does not tell what it compares.
std::vector<std::string> compared_devices(const ExternalConfig& config);

}  // namespace drydock::rig_config

#pragma once

#include <cstdio>
#include <optional>
#include <string>

/// `drydock maneuver`: standard manoeuvres of a vehicle file and their usual figures.
namespace drydock::world {

struct ManeuverOptions {
  std::string vehicle;   ///< vehicle file (TOML)
  std::string kind;      ///< motion::maneuver_kind; may be empty with a schedule
  std::string schedule;  ///< CSV of motion::parse_schedule; empty: the kind's own commands
  std::optional<double> speed_mps;  ///< commanded; default: the propeller at 1500 rpm
  std::optional<double> deflection_deg, switch_deg;  ///< default: the kind's usual values
  std::optional<double> duration_s;                  ///< only for a schedule
  bool ideal_actuators = false, json = false;
  std::string csv, plot;  ///< files to write; empty: none
};

/// Exit code: 0 sailed; 1 a file cannot be written; 2 vehicle or schedule is wrong.
int maneuver(const ManeuverOptions& options, std::FILE* out, std::FILE* errors);

}  // namespace drydock::world

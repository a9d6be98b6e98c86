#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "hil/cli/host_floor.hpp"
#include "hil/study/study.hpp"
#include "hil/validity/figures.hpp"
#include "rig_config/rig.hpp"

/// `drydock validity`: how right the times of the measurements are.
/// docs/sensors/time-of-validity.md
namespace drydock::cli {

struct ValidityOptions {
  double duration_s = 30;    ///< of each run
  bool lockstep = false;     ///< --speed max: no floor, no lateness
  bool bauds = false;        ///< serial devices alone, at each rate from 4800 to 921600
  std::string json, report;  ///< file, folder; empty: none
};

/// One run of a rig's emulated devices.
struct ValidityRun {
  unsigned baud = 0;  ///< of all lines; 0: as the rig has them
  std::vector<validity::Figures> figures;
  HostTimes floor;
};

study::Table table_of(const ValidityRun& run);
/// Device by baud rate: the 99th percentile of the error.
study::Table sweep_table(const std::vector<ValidityRun>& runs);
std::vector<study::Figure> figures_of(const ValidityRun& run);
nlohmann::ordered_json json_of(const ValidityRun& run);

/// Its emulated devices alone: only of them is it known when a sample was taken. Throws
/// std::runtime_error where there is none.
rig_config::Rig with_truth(rig_config::Rig rig);

/// Exit code. Throws std::runtime_error with one line where the rig cannot run.
int measure_validity(const rig_config::Rig& rig, const ValidityOptions& options);

}  // namespace drydock::cli

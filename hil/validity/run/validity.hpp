#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "hil/report/figure.hpp"
#include "hil/report/table.hpp"
#include "hil/validity/figures.hpp"
#include "hil/validity/run/host_floor.hpp"
#include "rig_config/rig.hpp"

/// `drydock validity`: the accuracy of measurement times. docs/sensors/time-of-validity.md
namespace drydock::validity {

struct ValidityOptions {
  double duration_s = 30;    ///< each run
  bool lockstep = false;     ///< --speed max: without host floor and without lateness
  bool bauds = false;        ///< serial devices only, at each rate from 4800 to 921600
  std::string json, report;  ///< file, folder; empty: none
};

/// One run of the rig's emulated devices.
struct ValidityRun {
  unsigned baud = 0;  ///< the same for all lines; 0: as in the rig file
  std::vector<validity::Figures> figures;
  HostTimes floor;
};

report::Table table_of(const ValidityRun& run);
/// The 99th percentile of the error, by device and baud rate.
report::Table sweep_table(const std::vector<ValidityRun>& runs);
std::vector<report::Figure> figures_of(const ValidityRun& run);
nlohmann::ordered_json json_of(const ValidityRun& run);

/// The rig with its emulated devices only, because the true time of a sample is known only for
/// them. Throws std::runtime_error if there is none.
rig_config::Rig with_truth(rig_config::Rig rig);

/// Returns the exit code. Throws std::runtime_error with one line if the rig cannot run.
int measure_validity(const rig_config::Rig& rig, const ValidityOptions& options);

}  // namespace drydock::validity

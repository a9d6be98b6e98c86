#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/host/rig_recorder.hpp"
#include "drivers/host/rig_viewer.hpp"
#include "estimators/setup/outside.hpp"
#include "hil/bench/follower.hpp"
#include "hil/summary/summary.hpp"
#include "rig_config/rig.hpp"

namespace drydock::shell {
class Actor;
}
namespace drydock::motion {
class Trajectory;
}

namespace drydock::bench {

/// What a program puts into its lockstep run. All of it must outlive the run.
struct LockstepParts {
  const motion::Trajectory* motion = nullptr;  ///< of the vehicle; null: that of the mission
  std::vector<shell::Actor*> actors;           ///< act at their own times
  setup::Outside::Peers peers;                 ///< by estimator
  std::function<bool()> stopped;               ///< ends the run; asked once a second; empty: never
  bool progress = true;                        ///< a terminal shows how far the run is
};

struct RunOptions {
  double duration_s = 0;  ///< 0: until Ctrl-C (real time), one lap of the mission (lockstep)
  bool lockstep = false;  ///< --speed max
  std::string json, report, junit;  ///< file, folder, file; empty: none
  bool quiet = false;               ///< prints neither a table nor lines of states
  double curve_points = 1500;       ///< lockstep: points of each curve that the report keeps
  bool expect_streaming = false;
  std::optional<double> expect_rms_deg;  ///< for every estimator with a truth
  host::RecordOptions record;
  host::ServeOptions serve;          ///< real time only
  std::vector<Follower*> followers;  ///< hear everything after the run's own; must outlive it
  LockstepParts parts;
};

/// Runs the rig: emulated devices, drivers, estimators, in real time or in lockstep. Throws
/// std::runtime_error with one line when it cannot begin.
summary::Summary run_real_time(const rig_config::Rig& rig, const RunOptions& options);
summary::Summary run_lockstep(const rig_config::Rig& rig, const RunOptions& options);

/// The command `drydock run`: runs, prints, writes the files. Returns the exit code.
int run(const rig_config::Rig& rig, const RunOptions& options);

}  // namespace drydock::bench

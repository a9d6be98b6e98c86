#pragma once

#include <functional>
#include <optional>
#include <string>

#include "drivers/device/device.hpp"
#include "drivers/host/rig_recorder.hpp"
#include "drivers/host/rig_viewer.hpp"
#include "hil/emulate/real_time/real_time.hpp"
#include "hil/summary/summary.hpp"
#include "rig_config/rig.hpp"

namespace drydock::fault {
class Injector;
}

namespace drydock::bench {

/// A running bench, for code that observes it and sets faults.
struct RunView {
  measurement::Stamp now{};
  const std::vector<const device::Device*>& devices;  ///< in the order of the rig
  fault::Injector& faults;
};

using OnWritten = emulate::RealTimeEmulator::OnWritten;

struct RunOptions {
  double duration_s = 0;  ///< 0: until Ctrl-C (real time), one lap of the mission (lockstep)
  bool lockstep = false;  ///< --speed max
  std::string json, report, junit;  ///< file, folder, file; empty: none
  bool quiet = false;               ///< lockstep: prints no line for a change of state
  double curve_points = 1500;       ///< lockstep: points of each curve that the report keeps
  bool expect_streaming = false;
  std::optional<double> expect_rms_deg;  ///< for every estimator with a truth
  host::RecordOptions record;
  host::ServeOptions serve;                                             ///< real time only
  std::function<void(const measurement::Measurement&)> on_measurement;  ///< gets all measurements;
                                                                        ///< may be empty
  std::function<void(const RunView&)> each_second;                      ///< lockstep; may be empty
  /// Real time: gets the finished fraction, 0 to 1. If set, no table and no lines are printed.
  std::function<void(double done)> on_progress;
  OnWritten on_written;  ///< gets what emulated devices sent; may be empty
};

/// Runs the rig: emulated devices, drivers, estimators, in real time or in lockstep. Throws
/// std::runtime_error with one line when it cannot begin.
summary::Summary run_real_time(const rig_config::Rig& rig, const RunOptions& options);
summary::Summary run_lockstep(const rig_config::Rig& rig, const RunOptions& options);

/// The command `drydock run`: runs, prints, writes the files. Returns the exit code.
int run(const rig_config::Rig& rig, const RunOptions& options);

}  // namespace drydock::bench

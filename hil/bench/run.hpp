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

/// A run under way, for who looks at it from outside and puts faults on it.
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
  bool quiet = false;               ///< lockstep: no line for a change of state
  double curve_points = 1500;       ///< lockstep: of each curve kept for the report
  bool expect_streaming = false;
  std::optional<double> expect_rms_deg;  ///< of every estimator that has a truth
  host::RecordOptions record;
  host::ServeOptions serve;                                             ///< real time only
  std::function<void(const measurement::Measurement&)> on_measurement;  ///< hears all; may be empty
  std::function<void(const RunView&)> each_second;                      ///< lockstep; may be empty
  /// Real time: hears how much is done, of 1, instead of a table and lines; may be empty.
  std::function<void(double done)> on_progress;
  OnWritten on_written;  ///< hears what emulated devices sent; may be empty
};

/// Runs the rig: emulated devices, drivers, estimators, in real time or in lockstep.
/// Throws std::runtime_error with one line when it cannot begin.
summary::Summary run_real_time(const rig_config::Rig& rig, const RunOptions& options);
summary::Summary run_lockstep(const rig_config::Rig& rig, const RunOptions& options);

/// The command: runs, prints, writes the files. Returns the exit code.
int run(const rig_config::Rig& rig, const RunOptions& options);

/// The row of a device in the summary; shared by both ways to run.
summary::DeviceSummary summarise(const device::Device& device, const device::Health& health,
                                 measurement::Provenance provenance);

}  // namespace drydock::bench

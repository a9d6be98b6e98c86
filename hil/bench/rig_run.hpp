#pragma once

#include <optional>

#include "drivers/host/finding_log.hpp"
#include "drivers/host/late_wakes.hpp"
#include "drivers/host/rig_recorder.hpp"
#include "estimators/host/diagnostician.hpp"
#include "estimators/host/sound_devices.hpp"
#include "hil/bench/follower.hpp"
#include "hil/bench/loop_record.hpp"
#include "hil/bench/run.hpp"
#include "hil/bench/truth_teller.hpp"
#include "hil/emulate/real_time/real_time.hpp"
#include "hil/fault/injector.hpp"
#include "hil/summary/expect_watch.hpp"
#include "hil/summary/scribe.hpp"

namespace drydock::bench {

/// What real time and virtual time share: the followers of a run and its summary.
class RigRun {
 public:
  struct Setting {
    measurement::Stamp start;
    double expected_s = 0;  ///< for the spacing of the report's curves
    record::WhenBehind when_behind = record::WhenBehind::lose;
    host::Follower* first = nullptr;  ///< hears everything before the others; may be null
    bool others_hear_truth = true;    ///< those that are added later may need on_truth()
  };

  /// Makes the followers that the options ask for. All arguments must outlive the run. Throws
  /// std::runtime_error with one line if the recording cannot be made.
  RigRun(const rig_config::Rig& rig, const RunOptions& options, const motion::Trajectory& motion,
         const Setting& setting);

  host::Followers& followers() { return followers_; }
  /// Tells the followers what emulated devices sent; empty if the options name no follower.
  emulate::RealTimeEmulator::OnWritten on_written();

  /// Call it before the first byte. The parts of the bench must outlive the run.
  void begin(const BenchView& bench);

  /// Tells the followers the faults in force, if they changed since the last call.
  void tell_faults(measurement::Stamp now);
  void tell_health(measurement::Stamp now);

  std::vector<summary::DeviceSummary> devices(measurement::Stamp now) const;

  /// Call it at the end. Ends the recording and fills in everything except times, devices and
  /// faults.
  void write(summary::Summary& summary);

 private:
  std::vector<pipeline::EstimatorStatus> estimators() const;
  void write_programs(summary::Summary& summary) const;

  const rig_config::Rig& rig_;
  const RunOptions& options_;
  measurement::Stamp start_;
  const motion::Trajectory* truth_;  ///< null: no emulated truth
  host::Followers followers_;
  host::Diagnostician diagnostician_;
  host::FindingLog findings_;
  host::LateWakes late_wakes_;
  summary::Scribe scribe_;
  summary::ExpectWatch expects_;
  std::optional<TruthTeller> truth_teller_;
  std::optional<LoopRecord> loop_;  ///< empty: nobody steers over the wires
  std::optional<host::RigRecorder> recorder_;
  std::optional<host::SoundDevices> sound_devices_;
  std::optional<BenchView> bench_;
  std::vector<fault::FaultNow> faults_told_;
};

}  // namespace drydock::bench

#pragma once

#include <map>
#include <memory>
#include <vector>

#include "drivers/device/device.hpp"
#include "drivers/diagnosis/finding.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "hil/motion/truth.hpp"
#include "hil/scorecard/field.hpp"
#include "rig_config/rig.hpp"

/// The record of one lockstep run, for comparison with another. Times are seconds of the run.
namespace drydock::scorecard {

struct Sample {
  double valid_s = 0, received_s = 0, value = 0;
  std::size_t message = 0;  ///< index of the device's message, from 0
};

/// One number of a device's measurements, in the order of arrival.
struct Series {
  std::string_view name;
  Role role = Role::value;
  bool angle = false;
  std::vector<Sample> samples;
};

/// Which of the first 64 series of a device a message contained.
struct Arrival {
  double received_s = 0;
  std::size_t kind = 0;      ///< kind of measurement
  std::uint64_t fields = 0;  ///< one bit per series
};

struct Change {
  double at_s = 0;
  device::State to = device::State::closed;
};

/// Driver status and estimator counters, taken every poll_s.
struct Look {
  double at_s = 0;
  std::uint64_t bad_checksums = 0, skipped = 0, error_frames = 0;
  device::Reason trouble;
  std::optional<double> rate_hz;
  std::uint64_t late = 0, refused = 0;  ///< messages of this device, counted by the pipeline
  std::uint64_t rejected = 0;           ///< by the estimators' gates, for all devices
  std::uint64_t not_running = 0;        ///< number of estimators that wait or are lost
};

struct DeviceRecord {
  std::map<std::uint32_t, Series> series;
  std::vector<Arrival> arrivals;
  std::vector<Change> changes;
  std::vector<Look> looks;
};

/// The error of an estimate against the truth.
struct ErrorAt {
  double at_s = 0;
  double tilt_deg = 0;  ///< norm of roll and pitch errors
  double nees = 0;      ///< roll and pitch, per axis
  std::optional<double> horizontal_m;
  bool valid = true;  ///< the estimator said so
  double sigmas = 0;  ///< largest error of an axis, over the estimator's own standard deviation
};

/// A finding of the diagnosis.
struct FindingAt {
  std::size_t device = 0;
  diagnosis::Cause cause = diagnosis::Cause::silent;
  double since_s = 0, found_s = 0;
  std::optional<double> until_s;  ///< empty: it lasted to the end
};

struct RunRecord {
  std::vector<FindingAt> findings;  ///< in the order in which they were found
  std::vector<DeviceRecord> devices;
  std::vector<std::vector<ErrorAt>> estimators;  ///< empty if there is no truth
};

inline constexpr double poll_s = 0.1;

/// A run that is recorded, in two parts: what comes before its faults may be shared with others.
class Recording {
 public:
  /// The rig must outlive the recording. Throws like LockstepBench.
  explicit Recording(const rig_config::Rig& rig);
  /// It takes the truth from the other recording, of a rig with the same mission and start.
  Recording(const rig_config::Rig& rig, const Recording& of_same_motion);
  ~Recording();

  /// Runs to the last look before this time.
  void run_before(double time_s);
  /// Takes memory for the rest of a run that is as long as this one, so that what is recorded now
  /// stays where it is.
  void make_room(const RunRecord& of_like_run);
  /// Its start counts from the begin of the run, and has not come yet.
  void set(const rig_config::FaultConfig& fault);
  /// Runs to the end; call it last.
  RunRecord run_to(double end_s);

 private:
  class Recorder;
  std::unique_ptr<Recorder> recorder_;
};

/// Runs the rig with its faults for this time. Throws like LockstepBench.
RunRecord record_run(const rig_config::Rig& rig, double duration_s);

}  // namespace drydock::scorecard

#pragma once

#include <map>
#include <memory>
#include <vector>

#include "drivers/device/device.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "hil/motion/truth.hpp"
#include "hil/scorecard/field.hpp"
#include "rig_config/rig.hpp"

/// What is kept of one run in lockstep, to be held against another. Times: seconds of the run.
namespace drydock::scorecard {

struct Sample {
  double valid_s = 0, received_s = 0, value = 0;
  std::size_t message = 0;  ///< of the device, from 0
};

/// One number of a device's measurements, as it came.
struct Series {
  std::string_view name;
  Role role = Role::value;
  bool angle = false;
  std::vector<Sample> samples;
};

/// Which numbers a message had, of a device's first 64 series.
struct Arrival {
  double received_s = 0;
  std::size_t kind = 0;      ///< of measurement
  std::uint64_t fields = 0;  ///< a bit a series
};

struct Change {
  double at_s = 0;
  device::State to = device::State::closed;
};

/// What the driver tells of itself, and the estimators of what they were given, every poll_s.
struct Look {
  double at_s = 0;
  std::uint64_t bad_checksums = 0, skipped = 0, error_frames = 0;
  device::Reason trouble;
  std::optional<double> rate_hz;
  std::uint64_t late = 0, refused = 0;  ///< by the pipeline, of this device
  std::uint64_t rejected = 0;           ///< by the estimators' gates, of all devices
  std::uint64_t not_running = 0;        ///< estimators that wait or are lost
};

struct DeviceRecord {
  std::map<std::uint32_t, Series> series;
  std::vector<Arrival> arrivals;
  std::vector<Change> changes;
  std::vector<Look> looks;
};

/// An estimate against the truth.
struct ErrorAt {
  double at_s = 0;
  double tilt_deg = 0;  ///< roll and pitch together
  double nees = 0;      ///< of roll and pitch, per axis
  std::optional<double> horizontal_m;
};

struct RunRecord {
  std::vector<DeviceRecord> devices;
  std::vector<std::vector<ErrorAt>> estimators;  ///< empty where there is no truth
};

inline constexpr double poll_s = 0.1;

/// Runs the rig with its faults for so long. Throws as LockstepBench does.
RunRecord record_run(const rig_config::Rig& rig, double duration_s);

}  // namespace drydock::scorecard

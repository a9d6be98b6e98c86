#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hil/cli/verdict.hpp"

namespace drydock::cli {

/// What a run was worth, as the report, the JSON file and the last lines on the terminal show it.
struct DeviceSummary {
  std::string name, kind, protocol, link, provenance, state, last_error;
  double nominal_rate_hz = 0, rate_hz = 0;
  std::uint64_t bytes_in = 0, bytes_good = 0, bytes_skipped = 0, bytes_held = 0;
  std::uint64_t frames = 0, bad_checksums = 0, messages = 0, reopens = 0;
};

/// Error of an attitude estimate against the truth, degrees.
struct AttitudeError {
  double roll_rms_deg = 0, pitch_rms_deg = 0, roll_max_deg = 0, pitch_max_deg = 0;
  double nees_mean = 0;  ///< normalised by the filter's own covariance, per axis; 1 is consistent
};

/// Error of a navigation estimate against the truth.
struct NavigationError {
  double horizontal_rms_m = 0, horizontal_max_m = 0, horizontal_end_m = 0;
  double depth_rms_m = 0;
  double velocity_rms_mps = 0, velocity_max_mps = 0;  ///< of the vector, over ground
  double roll_rms_deg = 0, pitch_rms_deg = 0, heading_rms_deg = 0;
  double nees_position = 0;  ///< horizontal, per axis; 1 is consistent
};

struct EstimatorSummary {
  std::string name, kind;
  std::uint64_t estimates = 0;
  std::uint64_t rejected = 0;  ///< sensors' values outside its gate
  std::optional<double> nis;   ///< mean normalised square of innovations taken; empty: none
  std::optional<AttitudeError> whole_run;  ///< empty where there is no truth
  std::optional<AttitudeError> after_10_s;
  std::optional<NavigationError> navigation;  ///< of kinds navigation and velocity
};

/// Curves for the report, thinned to at most a few thousand points.
struct AttitudeTrace {
  std::vector<double> t_s, roll_deg, pitch_deg, true_roll_deg, true_pitch_deg;
  std::vector<double> roll_sigma_deg, pitch_sigma_deg;
};

/// Where a navigation was, in metres from its first estimate, and how far off; what has no truth is
/// empty. Sigma: one standard deviation, as the filter has it.
struct NavigationTrace {
  std::vector<double> t_s, north_m, east_m, true_north_m, true_east_m;
  std::vector<double> north_error_m, east_error_m, north_sigma_m, east_sigma_m;
  std::array<std::vector<double>, 3> velocity_error_mps, velocity_sigma_mps;  ///< NED
  std::vector<double> current_north_mps, current_east_mps;
};

struct MotionTrace {
  std::vector<double> t_s, north_m, east_m, depth_m, speed_mps, heading_deg;
};

/// A fault that was in force, times from the start of the run.
struct FaultSummary {
  std::string device, words;
  double since_s = 0;
  std::optional<double> until_s;  ///< empty: to the end
};

/// What the process held in memory as the run went on.
struct ResidentTrace {
  std::vector<double> t_s, megabytes;
};

struct MeasurementTrace {
  std::string title, unit;
  std::vector<std::string> labels;
  std::vector<std::vector<double>> t_s, value;  ///< one vector a label
};

struct Summary {
  std::string rig, mode;
  std::uint64_t seed = 0;
  double duration_s = 0, wall_s = 0;
  bool interrupted = false;
  std::vector<std::string> notes;  ///< for a person: which CAN level, what was left out
  std::vector<DeviceSummary> devices;
  std::vector<EstimatorSummary> estimators;
  std::vector<FaultSummary> faults;
  std::vector<Verdict> verdicts;            ///< on the rig's [[expect]]
  std::vector<AttitudeTrace> traces;        ///< one an estimator
  std::vector<NavigationTrace> navigation;  ///< one an estimator; empty of other kinds
  MotionTrace motion;                       ///< empty where there is no truth
  ResidentTrace resident;
  std::vector<MeasurementTrace> measurements;

  bool all_streaming() const;
  double speed() const { return wall_s > 0 ? duration_s / wall_s : 0; }  ///< times real time
};

/// The summary as JSON (without the curves), keys as in docs/use/run.md.
std::string to_json(const Summary& summary);

/// A table for a terminal.
std::string to_text(const Summary& summary);

/// One self-contained HTML page with health table and plots.
std::string to_html(const Summary& summary);

}  // namespace drydock::cli

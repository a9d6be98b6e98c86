#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drivers/bus/device.hpp"
#include "drivers/device/health_account.hpp"
#include "drivers/diagnosis/finding_account.hpp"
#include "estimators/pipeline/peer.hpp"
#include "hil/pilot/loop_account.hpp"
#include "hil/summary/verdict.hpp"

namespace drydock::summary {

/// The results of a run, as shown in the report, in the JSON file and on the terminal.
using DeviceSummary = device::HealthAccount;

/// Error of an attitude estimate against the truth, degrees. NaN: the estimates do not give it.
struct AttitudeError {
  double roll_rms_deg = 0, pitch_rms_deg = 0, roll_max_deg = 0, pitch_max_deg = 0;
  double nees_mean = 0;   ///< normalised by the filter's own covariance, per axis; 1 is consistent
  double settling_s = 0;  ///< from then on both within 1 degree; NaN: not even at the end
};

/// Error of a navigation estimate against the truth. NaN: the estimates do not give it.
struct NavigationError {
  double horizontal_rms_m = 0, horizontal_max_m = 0, horizontal_end_m = 0;
  double depth_rms_m = 0;
  double velocity_rms_mps = 0, velocity_max_mps = 0;  ///< velocity vector over ground
  double roll_rms_deg = 0, pitch_rms_deg = 0, heading_rms_deg = 0;
  double nees_position = 0;  ///< horizontal, per axis; 1 is consistent
};

struct EstimatorSummary {
  std::string name, kind;
  std::uint64_t estimates = 0;
  std::uint64_t rejected = 0;              ///< sensor values outside the estimator's gate
  std::optional<double> valid_share;       ///< of the estimates, as they say; empty: no estimate
  std::optional<bus::Integrity> promised;  ///< by the last estimate; empty: there was none
  std::optional<double> rate_hz;           ///< of the estimates; empty: fewer than two
  std::optional<double> nis;  ///< mean normalised square of accepted innovations; empty: none
  std::optional<AttitudeError> whole_run;  ///< empty if there is no truth
  std::optional<AttitudeError> after_10_s;
  std::optional<NavigationError> navigation;     ///< for the kinds navigation and velocity
  std::optional<pipeline::PeerAccount> program;  ///< of an estimator in another program
};

/// Curves for the report, reduced to at most a few thousand points.
struct AttitudeTrace {
  std::vector<double> t_s, roll_deg, pitch_deg, true_roll_deg, true_pitch_deg;
  std::vector<double> roll_sigma_deg, pitch_sigma_deg;
};

/// Positions in metres from the first estimate, and their errors. Vectors that need a truth are
/// empty without one. Sigma is one standard deviation of the filter.
struct NavigationTrace {
  std::vector<double> t_s, north_m, east_m, true_north_m, true_east_m;
  std::vector<double> north_error_m, east_error_m, north_sigma_m, east_sigma_m;
  std::array<std::vector<double>, 3> velocity_error_mps, velocity_sigma_mps;  ///< NED
  std::vector<double> current_north_mps, current_east_mps;
};

struct MotionTrace {
  std::vector<double> t_s, north_m, east_m, depth_m, speed_mps, heading_deg;
};

/// A fault that was in force. Times count from the start of the run.
struct FaultSummary {
  std::string device, words;
  double since_s = 0;
  std::optional<double> until_s;  ///< empty: until the end
};

/// Memory of the process during the run.
struct ResidentTrace {
  std::vector<double> t_s, megabytes;
};

struct MeasurementTrace {
  std::string device, title, unit;
  std::vector<std::string> labels;
  std::vector<std::vector<double>> t_s, value;  ///< one vector per label
};

struct Summary {
  std::string rig, mode;
  std::uint64_t seed = 0;
  double duration_s = 0, wall_s = 0;
  bool interrupted = false;
  std::vector<std::string> notes;  ///< for a person: which level of CAN is used, what was left out
  std::vector<DeviceSummary> devices;
  std::vector<EstimatorSummary> estimators;
  std::vector<FaultSummary> faults;
  std::vector<diagnosis::FindingAccount> findings;  ///< times count from the start of the run
  std::vector<Verdict> verdicts;                    ///< on the rig's [[expect]]
  std::vector<AttitudeTrace> traces;                ///< one per estimator
  std::vector<NavigationTrace> navigation;          ///< one per estimator; empty for other kinds
  MotionTrace motion;                               ///< empty if there is no truth
  ResidentTrace resident;
  std::optional<pilot::LoopAccount> loop;  ///< of a vehicle that is steered over the wires
  std::vector<MeasurementTrace> measurements;

  bool all_streaming() const;
  double speed() const { return wall_s > 0 ? duration_s / wall_s : 0; }  ///< factor on real time
};

/// The summary as JSON, without the curves; docs/use/run.md describes the keys.
std::string to_json(const Summary& summary);

/// A table for a terminal.
std::string to_text(const Summary& summary);

/// One self-contained HTML page with a health table and plots.
std::string to_html(const Summary& summary);

}  // namespace drydock::summary

#pragma once

#include <optional>

#include "drivers/measurement/measurement.hpp"
#include "estimators/frame/attitude.hpp"
#include "estimators/pipeline/reckoning/leap_gate.hpp"
#include "estimators/pipeline/reckoning/pair_watch.hpp"
#include "estimators/pipeline/reckoning/reckoning_options.hpp"

namespace drydock::pipeline {

/// Roll, pitch and heading of a dead reckoning, by a compass and by the DVL's own sensors: what is
/// impossible is left out, the one stands in for the other, and both are compared.
class ReckoningAttitude {
 public:
  explicit ReckoningAttitude(const ReckoningOptions& options);

  /// What became of a sample. `heading`: it told one that is used.
  struct Taken {
    bool heading = false, tilt = false;
    int wild = 0;  ///< values that no vehicle can cause, not used
    /// The heading made a step that no vehicle makes, or took it back: what may be wrong of it now.
    std::optional<double> stepped_rad;
  };
  Taken take(const measurement::AttitudeSample& sample);
  Taken take(const measurement::BottomVelocity& track);

  bool knows_heading(Stamp at) const;
  /// At that time, if the vehicle turned on. The heading is true.
  frame::Euler at(Stamp at) const;
  double turn_radps() const { return turn_radps_; }
  double heading_rad() const { return heading_rad_; }  ///< the newest

  /// One sigma of how the vehicle may have turned otherwise since the newest heading.
  double unknown_turn_rad(Stamp at) const;
  double roll_variance(Stamp at) const { return tilt_variance(roll_, at); }
  double pitch_variance(Stamp at) const { return tilt_variance(pitch_, at); }
  /// Compass and DVL do not contradict each other.
  bool agrees(Stamp now) const { return tilts_.agrees(now) && headings_.agrees(now); }

 private:
  void note_tilt(const std::optional<double>& told, Stamp at, LeapGate& gate, double& angle,
                 Taken& taken);
  void note_heading(double heading_rad, Stamp at, Taken& taken);
  double tilt_variance(const LeapGate& gate, Stamp at) const;
  void compare_tilts(const frame::Euler& head, Stamp at);
  void compare_headings(double by_dvl, Stamp at);
  bool is_recent(const std::optional<Stamp>& then, Stamp at, double within_s) const;

  std::optional<ReckoningDevice> dvl_;
  bool has_compass_;
  double variation_rad_, gap_s_, tilt_variance_, heading_sigma_rad_;
  double roll_rad_ = 0, pitch_rad_ = 0;
  double heading_rad_ = 0, turn_radps_ = 0;  ///< the newest, of heading_at_; over a second or so
  std::optional<Stamp> heading_at_, tilt_at_, compass_at_;  ///< tilt_at_: by the compass
  double beside_dvl_rad_ = 0;  ///< heading less that of the DVL's compass
  int beside_dvl_known_ = 0;   ///< headings that told it
  bool stands_in_ = false;     ///< the DVL's compass does, for the other
  LeapGate roll_, pitch_, heading_;
  PairWatch tilts_, headings_;
};

}  // namespace drydock::pipeline

#pragma once

#include "estimators/frame/attitude.hpp"
#include "estimators/pipeline/estimator.hpp"
#include "estimators/pipeline/inertial/navigation_estimate.hpp"
#include "estimators/pipeline/options.hpp"
#include "estimators/pipeline/reckoning/pair_watch.hpp"
#include "estimators/pipeline/reckoning/reckoning_attitude.hpp"
#include "estimators/pipeline/reckoning/speed_gate.hpp"
#include "estimators/pipeline/reckoning/turned_way.hpp"

namespace drydock::pipeline {

/// One sigma of how a vehicle may have turned in a time in which nobody told it, rad: at most 1,
/// where it may head anywhere.
double unseen_turn_rad(double dt);

/// Speed over ground, else through the water, turned into NED by the heading and summed up. It
/// gives an estimate for each speed that it uses. A gap is bridged by a line between the speeds
/// before and behind it, and counted. docs/estimators/dead-reckoning.md
class DeadReckoningEstimator final : public Estimator {
 public:
  /// No underwater vehicle exceeds this limit. A speed beyond it is refused.
  static constexpr double max_speed_mps = 100;

  DeadReckoningEstimator(Seat seat, const ReckoningOptions& options,
                         const PipelineOptions& pipeline);

  using Estimator::take;
  Outcome take(const measurement::ImuSample&, EstimateListener&) override {
    return Outcome::unused;
  }
  Outcome take(const measurement::BottomVelocity& track, EstimateListener& listener) override;
  Outcome take(const measurement::WaterSpeed& speed, EstimateListener& listener) override;
  Outcome take(const measurement::AttitudeSample& sample, EstimateListener& listener) override;
  Outcome take(const measurement::DepthSample& sample, EstimateListener& listener) override;
  Outcome take(const measurement::GnssFix& fix, EstimateListener& listener) override;
  void doubt(std::uint16_t device, bool doubted) override;
  const EstimatorStatus& status() const override { return status_; }

 private:
  /// True for a device that the estimator has, and whose sample this is.
  static bool is_of(const std::optional<ReckoningDevice>& device,
                    const measurement::Origin& origin) {
    return device && device->index == origin.device;
  }

  /// A speed at one instant, as measured, in NED, and the heading that turned it there.
  struct Speed {
    Stamp valid_at{};
    Eigen::Vector3d ned = Eigen::Vector3d::Zero();
    double heading_rad = 0;
    SpeedOver over = SpeedOver::ground;
  };

  /// Where the antenna was before the first speed came, or while none came.
  struct Start {
    frame::Position antenna;
    Stamp valid_at{};
    double sigma_m = 0;
  };

  void note(const ReckoningAttitude::Taken& taken, Stamp at);
  bool is_wild(SpeedGate& gate, Stamp at, const Eigen::Vector3d& body);
  bool is_recent(Stamp then, Stamp at) const;
  void compare(const Speed& water);
  void split_by(const Eigen::Vector2d& off, Stamp at);
  Outcome go_on(const Speed& speed, EstimateListener& listener);
  void move(const Speed& speed, double dt);
  Eigen::Vector2d mean_over_gap(const Eigen::Vector2d& from, const Speed& to) const;
  WayNoise noise_of(const Speed& speed, double dt) const;
  double unseen_heading_rad(Stamp at) const;
  double doubted_mps(SpeedOver over, Stamp at) const;
  void note_gap(double dt);
  void begin(const Speed& first);
  void begin_at_fix(const Speed& first);
  void carry_to(const Speed& first, double dt, double turned_rad);
  void follow_depth(Stamp at);
  void turn_to(Stamp at) { attitude_ = angles_.at(at); }
  void take_in_gap(const Start& fix, double age_s, EstimateListener& listener);
  void believe_fixes(double off_m, Stamp at);
  void use(const Start& fix, double age_s, EstimateListener& listener);
  void tell(const navigation::Innovations& rows, Stamp at, EstimateListener& listener);
  Eigen::Vector2d offset_of(const Start& fix) const;
  const std::optional<ReckoningDevice>& place() const;
  Eigen::Vector3d rotation_at_log() const;
  Eigen::Vector3d arm(const std::optional<ReckoningDevice>& device) const;
  void emit(EstimateListener& listener);
  NavigationEstimate estimate() const;
  double separation_variance(Stamp at) const;
  Integrity integrity_of(const NavigationEstimate& estimate) const;
  void note_fed_by(const std::optional<ReckoningDevice>& device);

  std::uint16_t index_;
  ReckoningOptions options_;
  std::chrono::nanoseconds gap_, max_age_;
  AlertLimits alert_;
  ReckoningFilter filter_;
  ReckoningAttitude angles_;
  frame::Euler attitude_;  ///< of the body at the last speed; the heading is true
  SpeedGate dvl_gate_, log_gate_;
  PairWatch fixes_, speeds_;   ///< fixes with the track, log with DVL
  double speeds_off_mps_ = 0;  ///< of the last log and DVL that contradicted
  Eigen::Vector2d split_mps_ = Eigen::Vector2d::Zero();  ///< taken for a current, body axes
  std::optional<Stamp> speeds_split_at_;                 ///< when that was taken for a current
  double loosened_mps_ = 0;  ///< a difference within the gate that the current was loosened by
  std::optional<Stamp> loosened_at_;
  /// How far fixes lay from the track, m2, when they were believed; the last time of that.
  double separation_m2_ = 0;
  std::optional<Stamp> separated_at_;
  bool gnss_doubted_ = false, heading_doubted_ = false;  ///< by a finding
  std::optional<Stamp> ground_at_, depth_at_;
  std::optional<Stamp> begun_at_;  ///< the first measurement: a given start is of this time
  std::optional<Start> fixed_;     ///< the newest fix before the first speed, or in a gap
  double depth_m_ = 0;             ///< of the depth sensor
  std::optional<frame::Position> position_;  ///< of the place whose speed is known
  double down_variance_ = 0;
  std::optional<Speed> last_;
  TurnedWay turned_;  ///< since the last speed
  Eigen::Vector3d last_ground_ = Eigen::Vector3d::Zero();
  int far_behind_ = 0;  ///< speeds in a row from the past
  std::uint32_t fed_by_ = 0;
  EstimatorStatus status_;
};

}  // namespace drydock::pipeline

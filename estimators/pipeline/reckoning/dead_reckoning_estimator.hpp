#pragma once

#include "estimators/frame/attitude.hpp"
#include "estimators/pipeline/estimator.hpp"
#include "estimators/pipeline/inertial/navigation_estimate.hpp"
#include "estimators/pipeline/options.hpp"

namespace drydock::pipeline {

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

  /// Where the antenna was before the first speed came.
  struct Start {
    frame::Position antenna;
    Stamp valid_at{};
  };

  void note_attitude(const measurement::BottomVelocity& track);
  bool knows_heading(Stamp at) const;
  bool is_recent(Stamp then, Stamp at) const;
  Outcome go_on(const Speed& speed, EstimateListener& listener);
  void move(const Speed& speed, double dt);
  void note_gap(double dt);
  void begin(const Speed& first);
  void follow_depth(Stamp at);
  void note_heading(double heading_rad, Stamp at);
  void turn_to(Stamp at);
  const std::optional<ReckoningDevice>& place() const;
  Eigen::Vector3d rotation_at_log() const;
  Eigen::Vector3d arm(const std::optional<ReckoningDevice>& device) const;
  void emit(EstimateListener& listener);
  NavigationEstimate estimate() const;
  Integrity integrity_of(const NavigationEstimate& estimate) const;
  void note_fed_by(const std::optional<ReckoningDevice>& device);

  std::uint16_t index_;
  ReckoningOptions options_;
  std::chrono::nanoseconds gap_, max_age_;
  AlertLimits alert_;
  ReckoningFilter filter_;
  frame::Euler attitude_;   ///< of the body at the last speed; the heading is true
  double heading_rad_ = 0;  ///< the newest, of heading_at_
  bool tilt_told_ = false;  ///< by the device of `heading`
  double turn_radps_ = 0;   ///< of the heading, over the last second or so
  std::optional<Stamp> heading_at_, ground_at_, depth_at_;
  std::optional<Stamp> begun_at_;  ///< the first measurement: a given start is of this time
  std::optional<Start> fixed_;     ///< the newest fix before the first speed
  double depth_m_ = 0;             ///< of the depth sensor
  std::optional<frame::Position> position_;  ///< of the place whose speed is known
  double down_variance_ = 0;
  std::optional<Speed> last_;
  Eigen::Vector3d last_ground_ = Eigen::Vector3d::Zero();
  int far_behind_ = 0;  ///< speeds in a row from the past
  std::uint32_t fed_by_ = 0;
  EstimatorStatus status_;
};

}  // namespace drydock::pipeline

#pragma once

#include <Eigen/Core>
#include <chrono>
#include <cstdint>
#include <optional>

#include "estimators/pipeline/estimator.hpp"
#include "estimators/pipeline/inertial/bridged_gap.hpp"
#include "estimators/pipeline/options.hpp"

namespace drydock::pipeline {

/// What estimators on one IMU and one speed log have in common: when they start, which samples they
/// refuse or find late, what a gap or a clock set back does. Gives an estimate for every IMU sample
/// once it runs; a speed is taken when it comes, and the next IMU sample shows it.
class ImuDrivenEstimator : public Estimator {
 public:
  /// Beyond these no underwater vehicle goes: such a sample is refused.
  static constexpr double max_specific_force_mps2 = 500;
  static constexpr double max_angular_rate_radps = 50;
  static constexpr double max_speed_mps = 100;

  using Estimator::take;
  Outcome take(const measurement::ImuSample& sample, EstimateListener& listener) final;
  Outcome take(const measurement::WaterSpeed& speed, EstimateListener& listener) final;
  const EstimatorStatus& status() const final { return status_; }

 protected:
  struct Correction {
    bool used = true;                                  ///< false: the speed is outside the gate
    std::optional<navigation::Innovation> innovation;  ///< where the estimator has one
  };

  /// `index` names the estimates; of `pipeline` the two time limits are used.
  ImuDrivenEstimator(std::uint16_t index, const EstimatorOptions& options,
                     const PipelineOptions& pipeline);

 private:
  /// Begins at a sample; the speed is 0 where no log is used.
  virtual void start(const measurement::ImuSample& sample, double speed_mps) = 0;
  /// The same after an IMU's silence.
  virtual void start_again(const measurement::ImuSample& sample, double speed_mps,
                           double silent_s) {
    static_cast<void>(silent_s);
    start(sample, speed_mps);
  }
  /// Samples are missing, the line between their neighbours stands for them; none: nothing to do.
  virtual void bridge(const BridgedGap&) {}
  /// Goes on by `dt` seconds with the mean force and rate of them.
  virtual void step(const Eigen::Vector3d& force, const Eigen::Vector3d& rate, double dt) = 0;
  void tell(const measurement::WaterSpeed& speed, const navigation::Innovation& innovation,
            EstimateListener& listener);
  /// A speed corrects the present state.
  virtual Correction correct(double speed_mps) = 0;
  /// Roll, pitch and covariance.
  virtual void fill(AttitudeEstimate& estimate) const = 0;

  struct Speed {
    measurement::Stamp valid_at;
    double mps = 0;
  };

  bool running() const { return status_.state == EstimatorState::running; }
  bool clock_was_set_back(const measurement::ImuSample& sample);
  void stop();
  bool try_start(const measurement::ImuSample& sample);
  void go_on(const measurement::ImuSample& sample);
  void emit(EstimateListener& listener);

  std::uint16_t index_, imu_;
  std::optional<std::uint16_t> log_;  ///< empty: not used, the vehicle does not move
  std::chrono::nanoseconds max_imu_gap_, max_speed_age_;
  std::optional<measurement::ImuSample> last_;  ///< its valid_at is the estimator's time
  std::optional<Stamp> stopped_at_;             ///< valid_at of the last sample in use before it
  double interval_s_ = 0;                       ///< between the last two samples; 0: none
  std::optional<Speed> speed_;                  ///< the newest, for the next start
  int far_behind_ = 0;                          ///< samples in a row
  std::uint32_t fed_by_ = 0;                    ///< since the last start
  EstimatorStatus status_;
};

}  // namespace drydock::pipeline

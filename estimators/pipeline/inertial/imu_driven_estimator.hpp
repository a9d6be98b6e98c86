#pragma once

#include <Eigen/Core>
#include <chrono>
#include <cstdint>
#include <optional>

#include "estimators/pipeline/estimator.hpp"
#include "estimators/pipeline/ground_witness.hpp"
#include "estimators/pipeline/imu_gate.hpp"
#include "estimators/pipeline/inertial/bridged_gap.hpp"
#include "estimators/pipeline/options.hpp"
#include "estimators/pipeline/trust.hpp"

namespace drydock::pipeline {

/// Base of the estimators with one IMU and one speed log. It handles the start, refused and late
/// samples, gaps, and a clock that was set back. While it runs it gives an estimate for every IMU
/// sample. It uses a speed at once; the next estimate shows the effect.
class ImuDrivenEstimator : public Estimator {
 public:
  /// No underwater vehicle exceeds this limit. A speed beyond it is refused.
  static constexpr double max_speed_mps = 100;

  using Estimator::take;
  Outcome take(const measurement::ImuSample& sample, EstimateListener& listener) final;
  Outcome take(const measurement::WaterSpeed& speed, EstimateListener& listener) final;
  Outcome take(const measurement::BottomVelocity& track, EstimateListener& listener) final;
  const EstimatorStatus& status() const final { return status_; }
  void doubt(std::uint16_t device, bool doubted) final;

 protected:
  struct Correction {
    bool used = true;                                  ///< false: the speed is outside the gate
    std::optional<navigation::Innovation> innovation;  ///< if the estimator has one
  };

  /// `log`: device index; empty: not used, the vehicle is stationary. `witness`: empty: nothing
  /// watches the IMU. From `pipeline` it uses only the limits.
  ImuDrivenEstimator(Seat seat, std::optional<std::uint16_t> log,
                     std::optional<GroundWitness> witness, const PipelineOptions& pipeline);

 private:
  /// Starts at a sample. The speed is 0 if no log is used.
  virtual void start(const measurement::ImuSample& sample, double speed_mps) = 0;
  /// Starts again after the IMU was silent for `silent_s`.
  virtual void start_again(const measurement::ImuSample& sample, double speed_mps,
                           double silent_s) {
    static_cast<void>(silent_s);
    start(sample, speed_mps);
  }
  /// Samples are missing and were interpolated. A filter with a covariance enlarges it here.
  virtual void bridge(const BridgedGap&) {}
  /// The biases of gyros (rad/s) and accelerometers (m/s2) may have changed by these sigmas, per
  /// axis. A filter with a covariance enlarges it here.
  virtual void loosen_biases(double rate_sigma, double force_sigma) = 0;
  /// A sample that step() will use, without any step of the IMU taken off.
  virtual void note(const measurement::ImuSample&) {}
  /// True if the motion that the estimate gives contradicts it: no vehicle moves so.
  virtual bool implausible() const { return false; }
  /// True if the innovations contradict the filter's covariance, of the motion or of the log.
  virtual bool contradicted() const { return false; }
  virtual bool log_contradicted() const { return false; }
  /// True if nothing tells the filter how wrong it is. Then it starts again behind a fault.
  virtual bool blind() const { return false; }
  /// Begins to judge the innovations anew.
  virtual void forget_innovations() {}
  /// The log has contradicted for so long that it is believed: it has changed by this much, m/s.
  virtual void believe_log(double) {}
  /// One step of `dt` seconds with the mean force and rate over it.
  virtual void step(const Eigen::Vector3d& force, const Eigen::Vector3d& rate, double dt) = 0;
  void tell(const measurement::WaterSpeed& speed, const navigation::Innovation& innovation,
            EstimateListener& listener);
  /// Corrects the present state with a speed. `trusted` = false: only compares it.
  virtual Correction correct(double speed_mps, bool trusted) = 0;
  /// Fills in roll, pitch and covariance.
  virtual void fill(AttitudeEstimate& estimate) const = 0;

  /// How much the biases of IMU and log are in doubt at a new start, one sigma.
  struct Doubt {
    double rate_radps = 0, force_mps2 = 0, speed_mps = 0;
  };
  struct Speed {
    measurement::Stamp valid_at;
    double mps = 0;
  };

  bool running() const { return status_.state == EstimatorState::running; }
  bool clock_was_set_back(const measurement::ImuSample& sample);
  void stop();
  void use(const measurement::ImuSample& sample, EstimateListener& listener);
  measurement::ImuSample without_step(const measurement::ImuSample& sample) const;
  void follow(const ImuStep& step);
  void judge(measurement::Stamp now);
  Correction correct_with(double speed_mps);
  void start_over(const Doubt& doubt);
  Integrity integrity_of(const AttitudeEstimate& estimate) const;
  bool try_start(const measurement::ImuSample& sample);
  void go_on(const measurement::ImuSample& sample);
  void emit(EstimateListener& listener);

  std::uint16_t index_, imu_;
  std::optional<std::uint16_t> log_;  ///< empty: not used, the vehicle is stationary
  std::optional<GroundWitness> witness_;
  std::chrono::nanoseconds max_imu_gap_, max_speed_age_;
  ImuGate gate_;
  AlertLimits alert_;
  Trust motion_, log_trust_, imu_trust_, witness_trust_;  ///< the last: also of implausible()
  bool imu_doubted_ = false;                              ///< by a finding
  int diverged_in_a_row_ = 0;
  std::optional<Stamp> diverged_at_;
  Doubt doubt_;                                           ///< for the next start
  Eigen::Vector3d rate_step_ = Eigen::Vector3d::Zero();   ///< of the IMU, since the start
  Eigen::Vector3d force_step_ = Eigen::Vector3d::Zero();  ///< likewise
  std::optional<measurement::ImuSample> last_;  ///< its valid_at is the time of the estimator
  std::optional<Stamp> stopped_at_;             ///< valid_at of the last sample before the stop
  double interval_s_ = 0;                       ///< between the last two samples; 0: none
  std::optional<Speed> speed_;                  ///< the newest speed, for the next start
  int far_behind_ = 0;                          ///< samples in a row from the past
  std::uint32_t fed_by_ = 0;                    ///< devices since the last start
  EstimatorStatus status_;
};

}  // namespace drydock::pipeline

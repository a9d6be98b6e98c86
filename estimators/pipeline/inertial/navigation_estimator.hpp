#pragma once

#include <boost/container/static_vector.hpp>
#include <memory>
#include <optional>

#include "estimators/pipeline/estimator.hpp"
#include "estimators/pipeline/imu_gate.hpp"
#include "estimators/pipeline/inertial/aided_inertial.hpp"
#include "estimators/pipeline/inertial/innovation_watch.hpp"
#include "estimators/pipeline/inertial/vehicle_witness.hpp"
#include "estimators/pipeline/options.hpp"
#include "estimators/pipeline/sample_noise.hpp"
#include "estimators/pipeline/trust.hpp"

namespace drydock::pipeline {

/// An inertial navigation with one IMU and its aiding sensors. It gives an estimate for every step.
/// A step lasts `step_s` or less: it ends at the IMU sample nearest to the valid_at of an aiding
/// sensor. It is computed when the next IMU sample arrives, because then all its measurements are
/// there.
class NavigationEstimator final : public Estimator {
 public:
  static constexpr double step_s = 0.1;
  static constexpr double max_speed_mps = 100;

  /// From `pipeline` it uses only the limits.
  NavigationEstimator(Seat seat, const InertialOptions& options, const PipelineOptions& pipeline);

  using Estimator::take;
  Outcome take(const measurement::ImuSample& sample, EstimateListener& listener) override;
  Outcome take(const measurement::WaterSpeed& speed, EstimateListener& listener) override;
  Outcome take(const measurement::BottomVelocity& track, EstimateListener& listener) override;
  Outcome take(const measurement::DepthSample& depth, EstimateListener& listener) override;
  Outcome take(const measurement::GnssFix& fix, EstimateListener& listener) override;
  Outcome take(const measurement::ActuatorState& state, EstimateListener& listener) override;
  Outcome take(const measurement::AttitudeSample& compass, EstimateListener& listener) override;
  const EstimatorStatus& status() const override { return status_; }
  void doubt(std::uint16_t device, bool doubted) override {
    if (device == imu_) imu_doubted_ = doubted;
  }

 private:
  /// A measurement that waits for the end of the step.
  struct Aiding {
    Aid kind = Aid::log;
    const AidingSensor* sensor;
    measurement::Stamp valid_at;
    Eigen::Vector3d value =
        Eigen::Vector3d::Zero();  ///< m/s; sigma of a position, m; or heading, rad
    frame::Position position;
  };

  bool running() const { return status_.state == EstimatorState::running; }
  void begin(const measurement::ImuSample& sample);
  void go_on(const measurement::ImuSample& sample, EstimateListener& listener);
  void add(const Eigen::Vector3d& rate, const Eigen::Vector3d& force,
           const Eigen::Vector3d& rate_change, double dt);
  void end_step_if_due(EstimateListener& listener);
  void apply(const Aiding& aiding, EstimateListener& listener);
  Innovations update(const Aiding& aiding);
  void tell(Aid aid, measurement::Stamp valid_at, std::uint16_t device, const Innovations& rows,
            EstimateListener& listener);
  void note_fed_by(std::uint16_t device) { fed_by_ |= std::uint32_t{1} << device; }
  bool passes_gate(const measurement::ImuSample& sample);
  measurement::ImuSample without_step(const measurement::ImuSample& sample) const;
  bool was_wrong(measurement::Stamp now) const;
  void widen_by_noise(double dt);
  void judge(double lasted_s);
  void judge_model();
  double speed_off_mps() const;  ///< of the navigation, as the last values tell
  Integrity integrity_of(const NavigationEstimate& estimate) const;
  Outcome wait_for_step(const Aiding& aiding);
  void lose();
  bool clock_was_set_back(measurement::Stamp at);
  void emit(EstimateListener& listener);
  /// Velocity of a point of the body minus that of the origin, m/s, body axes.
  Eigen::Vector3d turning_speed(const Eigen::Vector3d& lever) const {
    return (rate_ - filter_->gyro_bias()).cross(lever);
  }

  std::uint16_t index_, imu_;
  InertialOptions options_;
  std::chrono::nanoseconds period_, max_imu_gap_, max_age_;
  ImuGate gate_;
  AlertLimits alert_;
  Eigen::Vector3d rate_step_ = Eigen::Vector3d::Zero();   ///< of the IMU, since the start
  Eigen::Vector3d force_step_ = Eigen::Vector3d::Zero();  ///< likewise
  InnovationWatch watch_;
  std::optional<VehicleWitness> vehicle_;  ///< empty: the method has no vehicle
  SampleNoise noise_;
  Trust aiding_, state_, model_, imu_trust_, vehicle_trust_;
  bool imu_doubted_ = false;  ///< by a finding
  std::unique_ptr<AidedInertial> filter_;
  hydrodynamics::Control control_;
  std::optional<measurement::ImuSample> last_;
  measurement::Stamp now_{};                        ///< valid_at of the last sample in the filter
  measurement::Stamp step_began_{};                 ///< the time of the filter's state
  Eigen::Vector3d rate_ = Eigen::Vector3d::Zero();  ///< newest, rad/s
  boost::container::static_vector<Aiding, 16> waiting_;
  double strayed_m_ = 0;  ///< what speed_off_mps() makes since the aiding contradicts
  int far_behind_ = 0;    ///< IMU samples in a row from the past
  std::uint32_t fed_by_ = 0;
  EstimatorStatus status_;
};

}  // namespace drydock::pipeline

#pragma once

#include <array>

#include "drivers/measurement/measurement.hpp"
#include "estimators/leveling/augmented_leveling_filter.hpp"
#include "estimators/leveling/imu_grade.hpp"
#include "estimators/navigation/constraint_mean.hpp"
#include "estimators/navigation/innovation_window.hpp"
#include "estimators/pipeline/aiding_sensor.hpp"
#include "estimators/pipeline/successive_noise.hpp"

namespace drydock::pipeline {

/// A DVL that watches an IMU: gravity, turned by the gyros, and the specific force must give the
/// velocity over ground that the DVL measures. A tilt that is wrong by .3 degrees accelerates this
/// velocity by .05 m/s2, so a gyro that drifts shows within seconds. The DVL changes no estimate.
/// "The witness" of docs/estimators/integrity.md. Allocates nothing, throws nothing.
class GroundWitness {
 public:
  /// `lever`: from the IMU to the DVL. `options`: latitude and heading count. `imu`: how well the
  /// IMU measures.
  GroundWitness(const AidingSensor& dvl, const leveling::LevelingOptions& options,
                const leveling::ImuGrade& imu);

  std::uint16_t device() const { return dvl_.device; }

  /// Begins anew. The biases of gyros and accelerometers, rad/s and m/s2, are in doubt by so much.
  void start(const measurement::ImuSample& sample, double rate_sigma, double force_sigma);
  void loosen(double velocity_sigma_mps, double angle_sigma_rad);
  void loosen_biases(double rate_sigma, double force_sigma);
  /// One step of `dt` seconds with the mean force and rate over it.
  void step(const Eigen::Vector3d& force, const Eigen::Vector3d& rate, double dt);
  /// A velocity of now; it must be finite.
  void compare(const Eigen::Vector3d& velocity);

  bool contradicts() const;

 private:
  void forget();
  void begin(const Eigen::Vector3d& velocity);
  void use(const Eigen::Vector3d& velocity, const std::array<double, 3>& sigmas);

  AidingSensor dvl_;
  leveling::AugmentedLevelingFilter filter_;
  /// The noise of a DVL until it is learned, and the least that is believed, m/s.
  static constexpr double first_noise_mps = 0.05, least_noise_mps = 0.01;

  struct Axis {
    navigation::InnovationWindow window;
    navigation::ConstraintMean brief{0.6}, longer{2};
    SuccessiveNoise noise{first_noise_mps * first_noise_mps, least_noise_mps* least_noise_mps};
    void clear();
    bool contradicts() const;
  };
  std::array<Axis, 3> axes_;
  Eigen::Vector3d rate_ = Eigen::Vector3d::Zero();  ///< of the last step
  Eigen::Vector3d acceleration_ = Eigen::Vector3d::Zero(), velocity_ = acceleration_;
  double elapsed_s_ = 0;  ///< since the last velocity
  int refused_ = 0;       ///< velocities in a row
};

}  // namespace drydock::pipeline

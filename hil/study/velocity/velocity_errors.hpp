#pragma once

#include <array>
#include <optional>

#include "estimators/navigation/aided_navigation.hpp"
#include "hil/sensor/random.hpp"
#include "hil/study/velocity/velocity_mission.hpp"

/// The errors of Table 2 on a recorded mission, for one run. They are the same for every method.
namespace drydock::study {

/// Table 2, one standard deviation each, and the additional errors of the stress cases.
struct VelocityErrors {
  double position_m = 10, height_m = 1, velocity_mps = 0.1;
  Eigen::Vector3d alignment_rad = navigation::NavigationOptions{}.alignment_rad;
  double accel_bias_mps2 = navigation::NavigationOptions{}.accel_bias_mps2;
  double gyro_bias_radps = navigation::NavigationOptions{}.gyro_bias_radps;
  double scale = 0.3e-6;  ///< gyros and accelerometers
  double angle_noise_rad = navigation::NavigationOptions{}.angle_noise_rad;
  double velocity_noise_mps = navigation::NavigationOptions{}.velocity_noise_mps;
  double depth_m = 0.5, log_mps = 0.03, ground_mps = 0.03;  ///< white, per sample
  double log_scale = 0, log_bias_mps = 0;                   ///< stress `eml`
};

/// The sensor readings of one navigation step.
template <class Real>
struct BasicMeasuredStep {
  static constexpr std::size_t samples = RecordedMission::samples_a_step;
  std::array<Eigen::Vector3<Real>, samples> angle, velocity;
  std::array<Real, samples> height_m;
  Real mean_height_m;
  std::array<hydrodynamics::Control, samples> control;
  std::optional<Real> log_mps;                 ///< 2 Hz
  std::optional<Eigen::Vector3<Real>> ground;  ///< DVL, 1 Hz, body axes, m/s
};
using MeasuredStep = BasicMeasuredStep<double>;

/// Draws the errors of one run and returns its steps one after another.
class MeasuredMission {
 public:
  /// `gaps`: the DVL comes and goes every ten minutes. Otherwise it is present in the first hour.
  MeasuredMission(const RecordedMission& mission, const VelocityErrors& errors, bool gaps,
                  std::uint64_t seed, std::size_t run);

  /// The navigation's initial state.
  const navigation::NavigationState& start() const { return start_; }

  void measure(std::size_t step, MeasuredStep& out);

 private:
  double normal();  ///< N(0, 1)

  const RecordedMission& mission_;
  VelocityErrors errors_;
  bool gaps_;
  sensor::RandomStream random_;
  navigation::NavigationState start_;
  Eigen::Vector3d gyro_bias_, accel_bias_, gyro_scale_, accel_scale_;
  double log_scale_, log_bias_;
};

}  // namespace drydock::study

#pragma once

#include "estimators/pipeline/inertial/aided_inertial.hpp"
#include "estimators/pipeline/inertial/lately_corrected.hpp"
#include "estimators/velocity/velocity_filter.hpp"

namespace drydock::pipeline {

/// The velocity filter of Lee et al. (2016). Its vehicle simulator and the sensors give a velocity
/// through the water. This velocity aids the inertial navigation as if it were over ground.
class PaperInertial final : public AidedInertial {
 public:
  explicit PaperInertial(const InertialOptions& options);

  void control(const hydrodynamics::Control& control) override { control_ = control; }
  void add_imu(const Eigen::Vector3d& angle, const Eigen::Vector3d& velocity, double dt) override;
  Innovations add_height(double height_m) override;
  void step() override {}
  /// Steps the navigation, after the velocity filter is up to date. Compares both each second.
  Innovations settle() override;
  void doubt_model(bool doubted) override;
  void restart_model() override;
  /// Log, DVL and depth are compared with the model, so only the model tells of the navigation.
  bool diverged(const InnovationWatch& watch) const override {
    return !doubted_ && watch.contradicts(Aid::model);
  }
  Innovations update_ground(const Eigen::Vector3d& velocity_body) override {
    filter_.update_velocity(velocity_body);
    return filter_.innovations();
  }
  Innovations update_log(double longitudinal_mps) override {
    filter_.update_longitudinal(longitudinal_mps);
    return filter_.innovations();
  }
  void loosen(double velocity_sigma, double angle_sigma) override {
    aided_.loosen(velocity_sigma, angle_sigma);
  }
  void loosen_biases(double rate_sigma, double force_sigma) override {
    aided_.loosen_biases(rate_sigma, force_sigma);
  }
  void loosen_position(double sigma) override { aided_.loosen_position(sigma); }

  const navigation::NavigationState& state() const override { return aided_.state(); }
  const Eigen::Vector3d& gyro_bias() const override { return aided_.gyro_bias(); }
  std::uint64_t rejected() const override { return filter_.rejected() + aided_.rejected(); }
  /// Innovations of the sensors only. Those of the navigation come from the velocity filter, not
  /// from a sensor.
  navigation::InnovationTally taken() const override { return filter_.taken(); }
  void fill(NavigationEstimate& estimate) const override {
    fill_navigation(state(), aided_.covariance().topLeftCorner<9, 9>(), estimate);
  }

 private:
  Eigen::Matrix3d velocity_covariance() const;  ///< of the navigation, body axes
  Innovations compare(const Eigen::Vector3d& model_variance) const;
  velocity::Setting setting() const {
    return {aided_.body_to_ned().toRotationMatrix().transpose(), earth_rate_};
  }

  navigation::AidedNavigation aided_;
  velocity::VelocityFilter filter_;
  hydrodynamics::Control control_;
  Eigen::Vector3d earth_rate_;  ///< NED, rad/s
  double height_sum_ = 0;
  int heights_ = 0;
  bool doubted_ = false;  ///< the model
  LatelyCorrected by_model_;
  double elapsed_s_ = 0, compared_s_ = 0;  ///< since the last step, the last comparison
};

}  // namespace drydock::pipeline

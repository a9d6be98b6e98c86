#pragma once

#include "estimators/pipeline/inertial/aided_inertial.hpp"
#include "estimators/velocity/coupled_navigation.hpp"

namespace drydock::pipeline {

/// The velocity filter of this project: navigation, water and vehicle in one filter.
class CoupledInertial final : public AidedInertial {
 public:
  explicit CoupledInertial(const InertialOptions& options)
      : filter_(options.start, options.vehicle, coupled_options(options)) {}

  void control(const hydrodynamics::Control& control) override { control_ = control; }
  void add_imu(const Eigen::Vector3d& angle, const Eigen::Vector3d& velocity, double dt) override {
    filter_.add_imu(angle, velocity, dt);
  }
  Innovations add_height(double height_m) override {
    filter_.add_height(height_m);
    return filter_.innovations();
  }
  void step() override { filter_.step(control_); }
  Innovations update_ground(const Eigen::Vector3d& velocity_body) override {
    filter_.update_velocity(velocity_body);
    return filter_.innovations();
  }
  Innovations update_log(double longitudinal_mps) override {
    filter_.update_longitudinal(longitudinal_mps);
    return filter_.innovations();
  }
  void loosen(double velocity_sigma, double angle_sigma) override {
    filter_.loosen(velocity_sigma, angle_sigma);
  }
  void loosen_biases(double rate_sigma, double force_sigma) override {
    filter_.loosen_biases(rate_sigma, force_sigma);
  }
  void loosen_position(double sigma) override { filter_.loosen_position(sigma); }

  const navigation::NavigationState& state() const override { return filter_.state(); }
  const Eigen::Vector3d& gyro_bias() const override { return filter_.gyro_bias(); }
  std::uint64_t rejected() const override { return filter_.rejected(); }
  navigation::InnovationTally taken() const override { return filter_.taken(); }
  void fill(NavigationEstimate& estimate) const override {
    const auto& p = filter_.covariance();
    fill_navigation(state(), p.topLeftCorner<9, 9>(), estimate);
    estimate.current =
        CurrentEstimate{filter_.current_ned(),
                        p.diagonal().segment<2>(velocity::current_error).cwiseMax(0).cwiseSqrt()};
  }

 private:
  static velocity::CoupledOptions coupled_options(const InertialOptions& options) {
    velocity::CoupledOptions coupled;
    coupled.navigation = options.navigation;
    coupled.depth_sigma_m = options.depth_sigma_m;
    coupled.log_sigma_mps = options.log_sigma_mps;
    coupled.ground_sigma_mps = options.ground_sigma_mps;
    return coupled;
  }

  velocity::CoupledNavigation filter_;
  hydrodynamics::Control control_;
};

}  // namespace drydock::pipeline

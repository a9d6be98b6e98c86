#pragma once

#include <cmath>

#include "estimators/pipeline/inertial/aided_inertial.hpp"

namespace drydock::pipeline {

/// Inertial navigation with its 15-state filter, aided by the available sensors. A depth sensor
/// also drives the height loop. Without a depth sensor there is no height loop.
class SensorInertial final : public AidedInertial {
 public:
  explicit SensorInertial(const InertialOptions& options)
      : options_(options), aided_(options.start, navigation_options(options)) {}

  void add_imu(const Eigen::Vector3d& angle, const Eigen::Vector3d& velocity, double dt) override {
    aided_.add_imu(angle, velocity, dt);
  }
  Innovations add_height(double height_m) override {
    const double off = height_m - state().position.height_m;
    if (aided_.passes_height(off, options_.depth_sigma_m)) {
      height_sum_ += height_m;
      ++heights_;
    }
    return aided_.innovations();
  }
  void step() override {
    if (heights_ == 0) return aided_.step();
    const double mean = height_sum_ / heights_;
    aided_.step(mean);
    aided_.update_height(mean, options_.depth_sigma_m / std::sqrt(heights_));
    height_sum_ = heights_ = 0;
  }
  Innovations update_ground(const Eigen::Vector3d& velocity_body) override {
    aided_.update_velocity(velocity_body, Eigen::Vector3d::Constant(options_.ground_sigma_mps));
    return aided_.innovations();
  }
  Innovations update_position(const frame::Position& position, const Eigen::Vector3d& sigma,
                              const Eigen::Vector3d& lever) override {
    aided_.update_position(position, sigma, lever);
    return aided_.innovations();
  }
  Innovations update_heading(double true_heading_rad) override {
    aided_.update_heading(true_heading_rad, options_.heading_sigma_rad);
    return aided_.innovations();
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
  std::uint64_t rejected() const override { return aided_.rejected(); }
  navigation::InnovationTally taken() const override { return aided_.taken(); }
  void fill(NavigationEstimate& estimate) const override {
    fill_navigation(state(), aided_.covariance().topLeftCorner<9, 9>(), estimate);
  }

 private:
  static navigation::NavigationOptions navigation_options(const InertialOptions& options) {
    navigation::NavigationOptions chosen = options.navigation;
    if (!options.depth) chosen.height_loop_tau_s = chosen.height_noise_m = 0;
    return chosen;
  }

  InertialOptions options_;
  navigation::AidedNavigation aided_;
  double height_sum_ = 0;
  int heights_ = 0;
};

}  // namespace drydock::pipeline

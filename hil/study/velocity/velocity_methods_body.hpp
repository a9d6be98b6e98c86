#pragma once

#include "estimators/velocity/coupled_navigation_body.hpp"
#include "estimators/velocity/velocity_filter_body.hpp"
#include "hil/study/velocity/velocity_methods.hpp"

namespace drydock::study {

/// The common parts of `pure` and the two methods of the paper: SDINS with height loop and 15-state
/// covariance, and the rate relative to the Earth that the SDINS gives to a vehicle model.
template <class Real>
class AidedNavigator : public BasicNavigator<Real> {
 public:
  using Vector3 = Eigen::Vector3<Real>;
  using State = navigation::BasicNavigationState<Real>;
  using Measured = BasicMeasuredStep<Real>;
  using Model = hydrodynamics::BasicModel<Real>;

  explicit AidedNavigator(const State& start) : aided_(start, {}) {}
  const State& state() const override { return aided_.state(); }
  Eigen::Matrix2<Real> horizontal_covariance() const override {
    return aided_.covariance().template topLeftCorner<2, 2>();
  }

 protected:
  static constexpr double dt = RecordedMission::sample_s;

  velocity::BasicSetting<Real> setting() const {
    return {aided_.body_to_ned().toRotationMatrix().transpose(), aided_.earth_rate_ned()};
  }
  /// Relative to the Earth, with the bias estimated so far.
  Vector3 rate(const Vector3& angle, const velocity::BasicSetting<Real>& setting) const {
    return angle / dt - aided_.gyro_bias() - setting.ned_to_body * setting.earth_rate_ned;
  }
  Vector3 velocity_of_navigation() const { return BasicNavigator<Real>::velocity_body(); }

  navigation::BasicAidedNavigation<Real> aided_;
};

/// Nothing aids it. Its covariance is the linear covariance analysis of the SDINS.
template <class Real>
class PureNavigator final : public AidedNavigator<Real> {
 public:
  using Aided = AidedNavigator<Real>;
  using Aided::Aided;
  using Aided::aided_, Aided::dt;

  void step(const typename Aided::Measured& measured) override {
    for (std::size_t i = 0; i < measured.samples; ++i)
      aided_.add_imu(measured.angle[i], measured.velocity[i], dt);
    aided_.step(measured.mean_height_m);
  }
};

/// Koifman and Bar-Itzhack: while the DVL is missing, an open-loop simulator replaces it.
template <class Real>
class EarlierNavigator final : public AidedNavigator<Real> {
 public:
  using Aided = AidedNavigator<Real>;
  using Aided::aided_, Aided::dt;
  using Vector3 = typename Aided::Vector3;

  EarlierNavigator(const typename Aided::State& start, const typename Aided::Model& model)
      : Aided(start), simulator_(model, {}) {}

  void step(const typename Aided::Measured& measured) override {
    for (std::size_t i = 0; i < measured.samples; ++i) {
      if (simulating_) simulator_.step(this->setting(), measured.control[i], dt);
      aided_.add_imu(measured.angle[i], measured.velocity[i], dt);
    }
    aided_.step(measured.mean_height_m);
    aided_.update_height(measured.mean_height_m, 0.5 / std::sqrt(10));
    if (measured.ground) {
      aided_.update_velocity(*measured.ground, Vector3::Constant(0.03));
      steps_without_ground_ = 0;
      simulating_ = false;
    } else if (++steps_without_ground_ > 10) {
      if (!simulating_) start_simulator(measured.angle.back());
      aided_.update_velocity(simulated_velocity(), Vector3::Constant(0.03));
    }
  }
  Vector3 velocity_body() const override {
    return simulating_ ? simulated_velocity() : this->velocity_of_navigation();
  }

 private:
  Vector3 simulated_velocity() const { return simulator_.state().velocity.template head<3>(); }
  void start_simulator(const Vector3& angle) {
    simulator_.state().height_m = aided_.state().position.height_m;
    simulator_.state().velocity << this->velocity_of_navigation(),
        this->rate(angle, this->setting());
    simulating_ = true;
  }

  velocity::BasicSimulator<Real> simulator_;
  bool simulating_ = false;
  int steps_without_ground_ = 0;
};

/// The paper's method: the velocity filter combines simulator and sensors and aids the SDINS.
template <class Real>
class PaperNavigator final : public AidedNavigator<Real> {
 public:
  using Aided = AidedNavigator<Real>;
  using Aided::aided_, Aided::dt;
  using Vector3 = typename Aided::Vector3;

  PaperNavigator(const typename Aided::State& start, const typename Aided::Model& model)
      : Aided(start), filter_(model, at_start(start)) {}

  void step(const typename Aided::Measured& measured) override {
    for (std::size_t i = 0; i < measured.samples; ++i) {
      const velocity::BasicSetting<Real> at = this->setting();
      filter_.predict(at, measured.control[i], dt);
      aided_.add_imu(measured.angle[i], measured.velocity[i], dt);
      filter_.update_rate(this->rate(measured.angle[i], at));
      filter_.update_height(measured.height_m[i]);
    }
    if (measured.log_mps) filter_.update_log(*measured.log_mps);
    if (measured.ground) filter_.update_velocity(*measured.ground);
    aided_.step(measured.mean_height_m);
    aided_.update_height(filter_.state().height_m, height_sigma_m);
    const Vector3 variance =
        filter_.velocity_sigma().array().square() + velocity_floor_mps * velocity_floor_mps;
    aided_.update_velocity(filter_.velocity(), variance.cwiseSqrt());
  }
  Vector3 velocity_body() const override { return filter_.velocity(); }

 private:
  static constexpr double height_sigma_m = 0.05;      ///< of the mean of ten depths, and of the
                                                      ///< velocity filter's depth
  static constexpr double velocity_floor_mps = 0.01;  ///< added to P^v: R of eq. (16)

  static velocity::BasicSimulated<Real> at_start(const typename Aided::State& start) {
    velocity::BasicSimulated<Real> simulated;
    simulated.height_m = start.position.height_m;
    simulated.velocity << start.body_to_ned.conjugate() * start.velocity_ned, Vector3::Zero();
    return simulated;
  }

  velocity::BasicVelocityFilter<Real> filter_;
};

template <class Real>
class OurNavigator final : public BasicNavigator<Real> {
 public:
  OurNavigator(const navigation::BasicNavigationState<Real>& start,
               const hydrodynamics::BasicModel<Real>& model)
      : coupled_(start, model.vehicle(), {}) {}

  void step(const BasicMeasuredStep<Real>& measured) override {
    for (std::size_t i = 0; i < measured.samples; ++i) {
      coupled_.add_imu(measured.angle[i], measured.velocity[i], RecordedMission::sample_s);
      coupled_.add_height(measured.height_m[i]);
    }
    coupled_.step(measured.control[measured.samples / 2]);
    if (measured.log_mps) coupled_.update_log(*measured.log_mps);
    if (measured.ground) coupled_.update_velocity(*measured.ground);
  }
  const navigation::BasicNavigationState<Real>& state() const override { return coupled_.state(); }
  Eigen::Matrix2<Real> horizontal_covariance() const override {
    return coupled_.covariance().template topLeftCorner<2, 2>();
  }

 private:
  velocity::BasicCoupledNavigation<Real> coupled_;
};

template <class Real>
std::unique_ptr<BasicNavigator<Real>> make_navigator(
    Method method, const navigation::BasicNavigationState<Real>& start,
    const hydrodynamics::BasicModel<Real>& model) {
  switch (method) {
    case Method::pure: return std::make_unique<PureNavigator<Real>>(start);
    case Method::earlier: return std::make_unique<EarlierNavigator<Real>>(start, model);
    case Method::paper: return std::make_unique<PaperNavigator<Real>>(start, model);
    case Method::ours: return std::make_unique<OurNavigator<Real>>(start, model);
  }
  return nullptr;
}

}  // namespace drydock::study

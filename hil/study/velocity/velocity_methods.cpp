#include "hil/study/velocity/velocity_methods.hpp"

#include "estimators/frame/earth.hpp"
#include "estimators/velocity/coupled_navigation.hpp"
#include "estimators/velocity/velocity_filter.hpp"

namespace drydock::study {
namespace {

using Eigen::Vector3d;
using navigation::AidedNavigation;
using navigation::NavigationState;

constexpr double dt = RecordedMission::sample_s;
constexpr double height_sigma_m = 0.05;      ///< of the mean of ten depths, and of the velocity
                                             ///< filter's depth
constexpr double velocity_floor_mps = 0.01;  ///< added to P^v: R of eq. (16)

/// The common parts of `pure` and the two methods of the paper: SDINS with height loop and 15-state
/// covariance, and the rate relative to the Earth that the SDINS gives to a vehicle model.
class AidedNavigator : public Navigator {
 public:
  explicit AidedNavigator(const NavigationState& start) : aided_(start, {}) {}
  const NavigationState& state() const override { return aided_.state(); }
  Eigen::Matrix2d horizontal_covariance() const override {
    return aided_.covariance().topLeftCorner<2, 2>();
  }

 protected:
  velocity::Setting setting() const {
    return {aided_.body_to_ned().toRotationMatrix().transpose(), earth_rate_};
  }
  /// Relative to the Earth, with the bias estimated so far.
  Vector3d rate(const Vector3d& angle, const velocity::Setting& setting) const {
    return angle / dt - aided_.gyro_bias() - setting.ned_to_body * setting.earth_rate_ned;
  }
  Vector3d velocity_of_navigation() const { return Navigator::velocity_body(); }
  void navigate(double reference_height_m) {
    aided_.step(reference_height_m);
    earth_rate_ = frame::earth_rate_ned(aided_.state().position.latitude_rad);
  }

  AidedNavigation aided_;
  Vector3d earth_rate_ = frame::earth_rate_ned(aided_.state().position.latitude_rad);
};

/// Nothing aids it. Its covariance is the linear covariance analysis of the SDINS.
class PureNavigator final : public AidedNavigator {
 public:
  using AidedNavigator::AidedNavigator;
  void step(const MeasuredStep& measured) override {
    for (std::size_t i = 0; i < MeasuredStep::samples; ++i)
      aided_.add_imu(measured.angle[i], measured.velocity[i], dt);
    navigate(measured.mean_height_m);
  }
};

/// Koifman and Bar-Itzhack: while the DVL is missing, an open-loop simulator replaces it.
class EarlierNavigator final : public AidedNavigator {
 public:
  EarlierNavigator(const NavigationState& start, const hydrodynamics::Model& model)
      : AidedNavigator(start), simulator_(model, {}) {}

  void step(const MeasuredStep& measured) override {
    for (std::size_t i = 0; i < MeasuredStep::samples; ++i) {
      if (simulating_) simulator_.step(setting(), measured.control[i], dt);
      aided_.add_imu(measured.angle[i], measured.velocity[i], dt);
    }
    navigate(measured.mean_height_m);
    aided_.update_height(measured.mean_height_m, 0.5 / std::sqrt(10));
    if (measured.ground) {
      aided_.update_velocity(*measured.ground, Vector3d::Constant(0.03));
      steps_without_ground_ = 0;
      simulating_ = false;
    } else if (++steps_without_ground_ > 10) {
      if (!simulating_) start_simulator(measured.angle.back());
      aided_.update_velocity(simulator_.state().velocity.head<3>(), Vector3d::Constant(0.03));
    }
  }
  Vector3d velocity_body() const override {
    return simulating_ ? Vector3d{simulator_.state().velocity.head<3>()} : velocity_of_navigation();
  }

 private:
  void start_simulator(const Vector3d& angle) {
    simulator_.state().height_m = aided_.state().position.height_m;
    simulator_.state().velocity << velocity_of_navigation(), rate(angle, setting());
    simulating_ = true;
  }

  velocity::Simulator simulator_;
  bool simulating_ = false;
  int steps_without_ground_ = 0;
};

/// The paper's method: the velocity filter combines simulator and sensors and aids the SDINS.
class PaperNavigator final : public AidedNavigator {
 public:
  PaperNavigator(const NavigationState& start, const hydrodynamics::Model& model)
      : AidedNavigator(start), filter_(model, at_start(start)) {}

  void step(const MeasuredStep& measured) override {
    for (std::size_t i = 0; i < MeasuredStep::samples; ++i) {
      const velocity::Setting at = setting();
      filter_.predict(at, measured.control[i], dt);
      aided_.add_imu(measured.angle[i], measured.velocity[i], dt);
      filter_.update_rate(rate(measured.angle[i], at));
      filter_.update_height(measured.height_m[i]);
    }
    if (measured.log_mps) filter_.update_log(*measured.log_mps);
    if (measured.ground) filter_.update_velocity(*measured.ground);
    navigate(measured.mean_height_m);
    aided_.update_height(filter_.state().height_m, height_sigma_m);
    const Vector3d variance =
        filter_.velocity_sigma().array().square() + velocity_floor_mps * velocity_floor_mps;
    aided_.update_velocity(filter_.velocity(), variance.cwiseSqrt());
  }
  Vector3d velocity_body() const override { return filter_.velocity(); }

 private:
  static velocity::Simulated at_start(const NavigationState& start) {
    velocity::Simulated simulated{.height_m = start.position.height_m};
    simulated.velocity << start.body_to_ned.conjugate() * start.velocity_ned, Vector3d::Zero();
    return simulated;
  }

  velocity::VelocityFilter filter_;
};

class OurNavigator final : public Navigator {
 public:
  OurNavigator(const NavigationState& start, const hydrodynamics::Model& model)
      : coupled_(start, model.vehicle(), {}) {}

  void step(const MeasuredStep& measured) override {
    for (std::size_t i = 0; i < MeasuredStep::samples; ++i) {
      coupled_.add_imu(measured.angle[i], measured.velocity[i], dt);
      coupled_.add_height(measured.height_m[i]);
    }
    coupled_.step(measured.control[MeasuredStep::samples / 2]);
    if (measured.log_mps) coupled_.update_log(*measured.log_mps);
    if (measured.ground) coupled_.update_velocity(*measured.ground);
  }
  const NavigationState& state() const override { return coupled_.state(); }
  Eigen::Matrix2d horizontal_covariance() const override {
    return coupled_.covariance().topLeftCorner<2, 2>();
  }

 private:
  velocity::CoupledNavigation coupled_;
};

}  // namespace

std::unique_ptr<Navigator> make_navigator(Method method, const NavigationState& start,
                                          const hydrodynamics::Model& model) {
  switch (method) {
    case Method::pure: return std::make_unique<PureNavigator>(start);
    case Method::earlier: return std::make_unique<EarlierNavigator>(start, model);
    case Method::paper: return std::make_unique<PaperNavigator>(start, model);
    case Method::ours: return std::make_unique<OurNavigator>(start, model);
  }
  return nullptr;
}

}  // namespace drydock::study

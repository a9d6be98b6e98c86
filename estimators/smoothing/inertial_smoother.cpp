#include "estimators/smoothing/inertial_smoother.hpp"

#include <cmath>

#include "estimators/frame/local_earth.hpp"
#include "estimators/smoothing/rts.hpp"

namespace drydock::smoothing {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using navigation::AidedNavigation;
using navigation::NavigationState;

constexpr int inertial_size = 15;
using InertialVector = Eigen::Matrix<double, inertial_size, 1>;
using InertialMatrix = Eigen::Matrix<double, inertial_size, inertial_size>;
using InertialStep = RtsStep<inertial_size>;

constexpr double step_s = 0.1;
constexpr double unseen_gap_s = 0.5;  ///< a longer pause of the IMU costs certainty
constexpr double gap_velocity_mps = 0.5, gap_angle_rad = 0.05;  ///< for each second of it; chosen
constexpr double unused_sigma_m = 1e4;  ///< of the height of a fix: depths tell the height

/// The state with both biases: what the errors of eq. (14) are taken away from.
struct Nominal {
  NavigationState state;
  Vector3d gyro_bias, accel_bias;
};

Vector3d rotation_vector(const Eigen::Quaterniond& q) {
  const Eigen::AngleAxisd turn(q);
  return turn.angle() * turn.axis();
}

/// The errors that lead from one nominal to another, in the signs of Sdins::correct().
InertialVector errors_between(const Nominal& from, const Nominal& to) {
  InertialVector e;
  const auto &a = from.state.position, &b = to.state.position;
  e << a.latitude_rad - b.latitude_rad, frame::wrap_pi(a.longitude_rad - b.longitude_rad),
      a.height_m - b.height_m, from.state.velocity_ned - to.state.velocity_ned,
      rotation_vector(to.state.body_to_ned * from.state.body_to_ned.conjugate()),
      to.gyro_bias - from.gyro_bias, to.accel_bias - from.accel_bias;
  return e;
}

Nominal nominal_of(const AidedNavigation& navigation) {
  return {navigation.state(), navigation.gyro_bias(), navigation.accel_bias()};
}

InertialMatrix covariance_of(const AidedNavigation& navigation) {
  return navigation.covariance().topLeftCorner<inertial_size, inertial_size>();
}

/// A state with the covariance of its first nine errors, in the units of a track.
TrackPoint point_of(double time_s, const NavigationState& state, const InertialMatrix& p) {
  const auto earth = frame::local_earth(state.position.latitude_rad, state.position.height_m);
  const Vector3d metres{earth.meridian_radius_m + state.position.height_m,
                        (earth.transverse_radius_m + state.position.height_m) * earth.cos_latitude,
                        -1};
  const Eigen::RowVector3d by_phi = navigation::heading_row(state.body_to_ned).by_phi;
  TrackPoint point;
  point.time_s = time_s;
  point.position = state.position;
  point.velocity_ned = state.velocity_ned;
  point.attitude = frame::euler(state.body_to_ned);
  point.position_covariance = metres.asDiagonal() * p.topLeftCorner<3, 3>() * metres.asDiagonal();
  point.velocity_covariance = p.block<3, 3>(navigation::velocity_error, navigation::velocity_error);
  const Matrix3d angles = p.block<3, 3>(navigation::phi, navigation::phi);
  point.heading_sigma_rad = std::sqrt((by_phi * angles * by_phi.transpose()).value());
  return point;
}

NavigationState corrected(const NavigationState& state, const InertialVector& errors) {
  navigation::Sdins sdins(state);
  sdins.correct(errors.segment<3>(navigation::position_error),
                errors.segment<3>(navigation::velocity_error), errors.segment<3>(navigation::phi));
  return sdins.state();
}

/// The forward pass. It keeps what the backward pass needs of each step.
class InertialPass {
 public:
  InertialPass(const Dive& dive, const InertialOptions& options)
      : dive_(dive), options_(options), navigation_(options.start, without_loop(options)) {
    track_.residuals.resize(dive.readings.size());
  }

  Track run() {
    if (dive_.inertial.empty()) return track_;
    now_ = began_ = dive_.inertial.front().time_s;
    reserve();
    while (next_ < dive_.readings.size() && dive_.readings[next_].time_s < now_) ++next_;
    for (std::size_t i = 1; i < dive_.inertial.size(); ++i)
      add(dive_.inertial[i - 1], dive_.inertial[i]);
    look_back();
    return std::move(track_);
  }

 private:
  /// A step holds three covariances (5.4 kB); steps that move whenever the vector grows take a
  /// third of the time. Each step ends at a sample: after `step_s`, or where a reading is due.
  void reserve() {
    const double duration_s = dive_.inertial.back().time_s - began_;
    const double steps = duration_s / step_s + static_cast<double>(dive_.readings.size());
    const auto samples = dive_.inertial.size();
    steps_.reserve(steps < static_cast<double>(samples) ? static_cast<std::size_t>(steps)
                                                        : samples);
    states_.reserve(steps_.capacity());
    track_.filtered.reserve(steps_.capacity());
  }

  static navigation::NavigationOptions without_loop(const InertialOptions& options) {
    auto navigation = options.navigation;
    navigation.height_loop_tau_s = 0;
    navigation.height_noise_m = 0;
    return navigation;
  }

  void add(const InertialReading& last, const InertialReading& sample) {
    const double dt = sample.time_s - last.time_s;
    if (!(dt > 0)) return;
    const bool means = options_.imu_means;
    const Vector3d rate = means ? sample.rate : Vector3d(0.5 * (last.rate + sample.rate));
    const Vector3d force = means ? sample.force : Vector3d(0.5 * (last.force + sample.force));
    const Vector3d& arm = options_.imu_lever;
    const Vector3d by_lever =
        (sample.rate - last.rate).cross(arm) + dt * rate.cross(rate.cross(arm));
    navigation_.add_imu(dt * rate, dt * force - by_lever, dt);
    if (dt > unseen_gap_s) navigation_.loosen(gap_velocity_mps * dt, gap_angle_rad * dt);
    now_ = sample.time_s;
    half_sample_s_ = dt / 2;
    if (is_due() || now_ - began_ >= step_s - half_sample_s_) end_step();
  }

  bool is_due() const {
    return next_ < dive_.readings.size() && dive_.readings[next_].time_s <= now_ + half_sample_s_;
  }

  void end_step() {
    navigation_.step();
    InertialStep step;
    step.transition.setIdentity();
    step.transition.topRows<9>() += (now_ - began_) * navigation_.dynamics();
    step.predicted = covariance_of(navigation_);
    const Nominal before = nominal_of(navigation_);
    for (; is_due(); ++next_) take(dive_.readings[next_], track_.residuals[next_]);
    step.filtered = covariance_of(navigation_);
    step.correction = errors_between(before, nominal_of(navigation_));
    steps_.push_back(step);
    states_.push_back(navigation_.state());
    track_.filtered.push_back(point_of(now_, navigation_.state(), step.filtered));
    began_ = now_;
  }

  void take(const Reading& reading, std::array<Residual, 3>& residuals) {
    if (!update(reading)) return;
    std::size_t axis = 0;
    for (const auto& row : navigation_.innovations())
      residuals.at(axis++) = {row.value, row.sigma, true, row.used};
    if (reading.quantity == Quantity::depth) residuals[0].value = -residuals[0].value;
    if (reading.quantity == Quantity::fix) residuals[2] = {};
  }

  /// False if the filter does not use the reading.
  bool update(const Reading& reading) {
    const Vector3d lever = reading.device < options_.levers.size() ? options_.levers[reading.device]
                                                                   : Vector3d(Vector3d::Zero());
    switch (reading.quantity) {
      case Quantity::bottom:
        if (!reading.value.allFinite()) return false;
        navigation_.update_velocity(reading.value, reading.sigma, lever);
        return true;
      case Quantity::depth:
        navigation_.update_height(options_.sea_level_m - reading.value.x(), reading.sigma.x(),
                                  lever);
        return true;
      case Quantity::heading:
        navigation_.update_heading(reading.value.x(), reading.sigma.x());
        return true;
      case Quantity::fix: {
        const frame::Position at{reading.value.x(), reading.value.y(),
                                 navigation_.state().position.height_m};
        navigation_.update_position(at, {reading.sigma.x(), reading.sigma.y(), unused_sigma_m},
                                    lever);
        return true;
      }
      case Quantity::log: break;
    }
    return false;
  }

  void look_back() {
    const auto results = smooth<inertial_size>(std::span<const InertialStep>(steps_));
    for (std::size_t k = 0; k < results.size(); ++k)
      track_.smoothed.push_back(point_of(track_.filtered[k].time_s,
                                         corrected(states_[k], results[k].correction),
                                         results[k].covariance));
  }

  const Dive& dive_;
  const InertialOptions& options_;
  AidedNavigation navigation_;
  Track track_;
  std::vector<InertialStep> steps_;
  std::vector<NavigationState> states_;
  std::size_t next_ = 0;
  double now_ = 0, began_ = 0, half_sample_s_ = 0;
};

}  // namespace

Track smooth_inertial(const Dive& dive, const InertialOptions& options) {
  return InertialPass(dive, options).run();
}

}  // namespace drydock::smoothing

#pragma once

#include <cstring>
#include <vector>

#include "hil/study/velocity/run_group.hpp"
#include "hil/study/velocity/velocity_methods_body.hpp"

namespace drydock::study {

/// A structure of numbers of several runs, from those of each run.
template <std::size_t width, class One, class Of, class Get>
void put_side_by_side(Of& all, const Get& run) {
  constexpr std::size_t numbers = sizeof(One) / sizeof(double);
  static_assert(sizeof(Of) == width * sizeof(One));
  double* const to = reinterpret_cast<double*>(&all);
  for (std::size_t lane = 0; lane < width; ++lane) {
    const double* const from = reinterpret_cast<const double*>(run(lane));
    for (std::size_t i = 0; i < numbers; ++i) to[i * width + lane] = from[i];
  }
}

template <class Real>
class BasicRunGroup final : public RunGroup {
 public:
  static constexpr std::size_t width = lanes::width<Real>;
  using State = navigation::BasicNavigationState<Real>;
  using Model = hydrodynamics::BasicModel<Real>;

  explicit BasicRunGroup(const GroupStart& start) {
    State state;
    put_side_by_side<width, navigation::NavigationState>(
        state, [&](std::size_t lane) { return start.states[lane]; });
    for (const GroupContender& contender : start.contenders) {
      const auto model = [&](std::size_t lane) { return contender.models[lane]; };
      hydrodynamics::BasicVehicle<Real> vehicle;
      hydrodynamics::BasicMatrix6<Real> inverse;
      put_side_by_side<width, hydrodynamics::Vehicle>(
          vehicle, [&](std::size_t lane) { return &model(lane)->vehicle(); });
      put_side_by_side<width, hydrodynamics::Matrix6>(
          inverse, [&](std::size_t lane) { return &model(lane)->inverse_mass(); });
      navigators_.push_back(make_navigator<Real>(contender.method, state, Model{vehicle, inverse}));
    }
  }

  void step(const MeasuredRuns& runs) override {
    for (std::size_t i = 0; i < runs.samples; ++i) {
      load(runs.angle[i], measured_.angle[i]);
      load(runs.velocity[i], measured_.velocity[i]);
      load(runs.height_m[i], measured_.height_m[i]);
      measured_.control[i] = runs.control[i];
    }
    load(runs.mean_height_m, measured_.mean_height_m);
    measured_.log_mps.reset();
    measured_.ground.reset();
    if (runs.has_log) load(runs.log_mps, measured_.log_mps.emplace());
    if (runs.has_ground) load(runs.ground, measured_.ground.emplace());
    for (const auto& navigator : navigators_) navigator->step(measured_);
  }

  NavigatorReading read(std::size_t contender, std::size_t run) const override {
    using lanes::lane;
    NavigatorReading reading;
    const BasicNavigator<Real>& navigator = *navigators_[contender];
    const int at = static_cast<int>(run);
    const frame::BasicPosition<Real>& position = navigator.state().position;
    reading.position.latitude_rad = lane(position.latitude_rad, at);
    reading.position.longitude_rad = lane(position.longitude_rad, at);
    reading.position.height_m = lane(position.height_m, at);
    const Eigen::Vector3<Real> velocity = navigator.velocity_body();
    for (int i = 0; i < 3; ++i) reading.velocity_body[i] = lane(velocity(i), at);
    const Eigen::Matrix2<Real> covariance = navigator.horizontal_covariance();
    for (int i = 0; i < 4; ++i) reading.horizontal_covariance[i] = lane(covariance.data()[i], at);
    return reading;
  }

 private:
  static void load(const Runs& from, Real& to) { std::memcpy(&to, from.data(), sizeof to); }
  static void load(const std::array<Runs, 3>& from, Eigen::Vector3<Real>& to) {
    for (std::size_t i = 0; i < 3; ++i) load(from[i], to(static_cast<int>(i)));
  }

  BasicMeasuredStep<Real> measured_;
  std::vector<std::unique_ptr<BasicNavigator<Real>>> navigators_;
};

}  // namespace drydock::study

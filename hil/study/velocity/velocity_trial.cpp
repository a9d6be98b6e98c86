#include "hil/study/velocity/velocity_trial.hpp"

#include <Eigen/LU>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/local_earth.hpp"

namespace drydock::study {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// Latitude and longitude, estimate minus truth, rad.
Vector2d angles_off(const MissionInstant& truth, const Navigator& navigator) {
  const auto& at = navigator.state().position;
  return {at.latitude_rad - truth.position.latitude_rad,
          frame::wrap_pi(at.longitude_rad - truth.position.longitude_rad)};
}

double per_state(const Vector2d& error, const Matrix2d& covariance) {
  return error.dot(covariance.inverse() * error) / 2;
}

void note_instant(const MissionInstant& truth, const Navigator& navigator, VelocityTrial& trial) {
  const frame::LocalEarth earth =
      frame::local_earth(truth.position.latitude_rad, truth.position.height_m);
  const Vector2d metres{earth.meridian_radius_m + truth.position.height_m,
                        earth.cos_latitude * (earth.transverse_radius_m + truth.position.height_m)};
  const Vector2d off = angles_off(truth, navigator);
  const Matrix2d covariance = navigator.horizontal_covariance();
  trial.north_m.push_back(off.x() * metres.x());
  trial.east_m.push_back(off.y() * metres.y());
  trial.up_m.push_back(navigator.state().position.height_m - truth.position.height_m);
  trial.stated_m2.push_back(covariance.diagonal().dot(metres.cwiseAbs2()));
  trial.nees.push_back(per_state(off, covariance));
  const Vector3d mps = navigator.velocity_body() - truth.velocity_body();
  for (std::size_t i = 0; i < 3; ++i) trial.mps[i].push_back(mps(static_cast<int>(i)));
}

/// The initial error of a navigator. No method can observe it, and it stays constant in latitude
/// and longitude. Its covariance is a constant part of every later covariance.
struct Beginning {
  Vector2d off;
  Matrix2d covariance;
};

void note_growth(const MissionInstant& truth, const Navigator& navigator,
                 const Beginning& beginning, VelocityTrial& trial) {
  trial.growth_nees.push_back(per_state(angles_off(truth, navigator) - beginning.off,
                                        navigator.horizontal_covariance() - beginning.covariance));
}

void note_velocity(const MissionInstant& truth, const Navigator& navigator, VelocityTrial& trial) {
  const Vector3d mps = navigator.velocity_body() - truth.velocity_body();
  trial.velocity_mean += mps;
  trial.velocity_square += mps.cwiseAbs2();
}

}  // namespace

std::vector<VelocityTrial> velocity_trial(const RecordedMission& mission,
                                          const VelocityErrors& errors, bool gaps,
                                          std::uint64_t seed, std::size_t run,
                                          std::span<const Contender> contenders) {
  constexpr std::size_t steps_a_second = 10;
  MeasuredMission sensors(mission, errors, gaps, seed, run);
  std::vector<std::unique_ptr<Navigator>> navigators;
  for (const auto& [method, model] : contenders)
    navigators.push_back(make_navigator(method, sensors.start(), *model));
  std::vector<VelocityTrial> trials(contenders.size());
  std::vector<Beginning> beginnings;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    trials[i].velocity_mean.setZero();
    trials[i].velocity_square.setZero();
    beginnings.push_back({angles_off(mission.instants.front(), *navigators[i]),
                          navigators[i]->horizontal_covariance()});
    note_instant(mission.instants.front(), *navigators[i], trials[i]);
  }
  MeasuredStep measured;
  for (std::size_t step = 0; step < mission.steps(); ++step) {
    sensors.measure(step, measured);
    const MissionInstant& truth = mission.instants[step + 1];
    for (std::size_t i = 0; i < trials.size(); ++i) {
      navigators[i]->step(measured);
      if ((step + 1) % steps_a_second == 0) note_velocity(truth, *navigators[i], trials[i]);
      if ((step + 1) % VelocityTrial::steps_an_instant != 0) continue;
      note_instant(truth, *navigators[i], trials[i]);
      note_growth(truth, *navigators[i], beginnings[i], trials[i]);
    }
  }
  const auto whole_seconds = mission.steps() / steps_a_second;  // a velocity was noted in each
  const double seconds = static_cast<double>(whole_seconds);
  for (auto& trial : trials) {
    trial.velocity_mean /= seconds;
    trial.velocity_square /= seconds;
  }
  return trials;
}

}  // namespace drydock::study

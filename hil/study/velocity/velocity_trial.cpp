#include "hil/study/velocity/velocity_trial.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/local_earth.hpp"

namespace drydock::study {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// Latitude and longitude, estimate minus truth, rad.
Vector2d angles_off(const MissionInstant& truth, const NavigatorReading& reading) {
  const auto& at = reading.position;
  return {at.latitude_rad - truth.position.latitude_rad,
          frame::wrap_pi(at.longitude_rad - truth.position.longitude_rad)};
}

double per_state(const Vector2d& error, const Matrix2d& covariance) {
  return error.dot(covariance.inverse() * error) / 2;
}

Matrix2d covariance_of(const NavigatorReading& reading) {
  return Eigen::Map<const Matrix2d>(reading.horizontal_covariance);
}

Vector3d velocity_off(const MissionInstant& truth, const NavigatorReading& reading) {
  return Eigen::Map<const Vector3d>(reading.velocity_body) - truth.velocity_body();
}

void note_instant(const MissionInstant& truth, const NavigatorReading& reading,
                  VelocityTrial& trial) {
  const frame::LocalEarth earth =
      frame::local_earth(truth.position.latitude_rad, truth.position.height_m);
  const Vector2d metres{earth.meridian_radius_m + truth.position.height_m,
                        earth.cos_latitude * (earth.transverse_radius_m + truth.position.height_m)};
  const Vector2d off = angles_off(truth, reading);
  const Matrix2d covariance = covariance_of(reading);
  trial.north_m.push_back(off.x() * metres.x());
  trial.east_m.push_back(off.y() * metres.y());
  trial.up_m.push_back(reading.position.height_m - truth.position.height_m);
  trial.stated_m2.push_back(covariance.diagonal().dot(metres.cwiseAbs2()));
  trial.nees.push_back(per_state(off, covariance));
  const Vector3d mps = velocity_off(truth, reading);
  for (std::size_t i = 0; i < 3; ++i) trial.mps[i].push_back(mps(static_cast<int>(i)));
}

/// The initial error of a navigator. No method can observe it, and it stays constant in latitude
/// and longitude. Its covariance is a constant part of every later covariance.
struct Beginning {
  Vector2d off;
  Matrix2d covariance;
};

void note_growth(const MissionInstant& truth, const NavigatorReading& reading,
                 const Beginning& beginning, VelocityTrial& trial) {
  trial.growth_nees.push_back(per_state(angles_off(truth, reading) - beginning.off,
                                        covariance_of(reading) - beginning.covariance));
}

void note_velocity(const MissionInstant& truth, const NavigatorReading& reading,
                   VelocityTrial& trial) {
  const Vector3d mps = velocity_off(truth, reading);
  trial.velocity_mean += mps;
  trial.velocity_square += mps.cwiseAbs2();
}

/// The contenders of all runs. Lanes without a run do the work of the last run again.
std::unique_ptr<RunGroup> make_group(const Registers& registers,
                                     const std::vector<MeasuredMission>& sensors,
                                     std::span<const std::vector<Contender>> contenders) {
  std::vector<GroupContender> all(contenders.front().size());
  GroupStart start{{}, all};
  for (std::size_t lane = 0; lane < registers.width; ++lane) {
    const std::size_t run = std::min(lane, sensors.size() - 1);
    start.states[lane] = &sensors[run].start();
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].method = contenders[run][i].method;
      all[i].models[lane] = contenders[run][i].model;
    }
  }
  return registers.make(start);
}

}  // namespace

std::vector<VelocityTrial> velocity_trial(const RecordedMission& mission,
                                          const VelocityErrors& errors, bool gaps,
                                          std::uint64_t seed, std::size_t run,
                                          std::span<const Contender> contenders) {
  const std::vector<Contender> one(contenders.begin(), contenders.end());
  return velocity_trials(mission, errors, gaps, seed, run, {&one, 1}, registers().front()).front();
}

std::vector<std::vector<VelocityTrial>> velocity_trials(
    const RecordedMission& mission, const VelocityErrors& errors, bool gaps, std::uint64_t seed,
    std::size_t run, std::span<const std::vector<Contender>> contenders,
    const Registers& registers) {
  constexpr std::size_t steps_a_second = 10;
  const std::size_t runs = contenders.size(), methods = contenders.front().size();
  std::vector<MeasuredMission> sensors;
  for (std::size_t k = 0; k < runs; ++k) sensors.emplace_back(mission, errors, gaps, seed, run + k);
  const auto group = make_group(registers, sensors, contenders);

  std::vector trials(runs, std::vector<VelocityTrial>(methods));
  std::vector beginnings(runs, std::vector<Beginning>(methods));
  const auto for_each = [&](const auto& note) {
    for (std::size_t k = 0; k < runs; ++k)
      for (std::size_t i = 0; i < methods; ++i)
        note(group->read(i, k), trials[k][i], beginnings[k][i]);
  };
  for_each([&](const NavigatorReading& reading, VelocityTrial& trial, Beginning& beginning) {
    trial.velocity_mean.setZero();
    trial.velocity_square.setZero();
    beginning = {angles_off(mission.instants.front(), reading), covariance_of(reading)};
    note_instant(mission.instants.front(), reading, trial);
  });
  MeasuredStep measured;
  const auto all_measured = std::make_unique<MeasuredRuns>();
  for (std::size_t step = 0; step < mission.steps(); ++step) {
    for (std::size_t k = 0; k < runs; ++k) {
      sensors[k].measure(step, measured);
      all_measured->put(k, measured);
    }
    for (std::size_t lane = runs; lane < registers.width; ++lane) all_measured->put(lane, measured);
    group->step(*all_measured);
    if ((step + 1) % steps_a_second != 0) continue;
    const MissionInstant& truth = mission.instants[step + 1];
    for_each([&](const NavigatorReading& reading, VelocityTrial& trial, Beginning& beginning) {
      note_velocity(truth, reading, trial);
      if ((step + 1) % VelocityTrial::steps_an_instant != 0) return;
      note_instant(truth, reading, trial);
      note_growth(truth, reading, beginning, trial);
    });
  }
  const auto whole_seconds = mission.steps() / steps_a_second;  // a velocity was noted in each
  const double seconds = static_cast<double>(whole_seconds);
  for (auto& of_run : trials) {
    for (auto& trial : of_run) {
      trial.velocity_mean /= seconds;
      trial.velocity_square /= seconds;
    }
  }
  return trials;
}

}  // namespace drydock::study

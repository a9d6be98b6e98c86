#pragma once

#include <span>
#include <vector>

#include "hil/study/velocity/run_group.hpp"

namespace drydock::study {

/// The results of one method in one run: errors once a minute, and velocity errors over every
/// second.
struct VelocityTrial {
  static constexpr std::size_t steps_an_instant = 600;

  std::vector<double> north_m, east_m, up_m;       ///< position
  std::vector<double> stated_m2;                   ///< trace of the position's covariance
  std::vector<double> nees;                        ///< position, over 2: 1 is consistent
  std::vector<double> growth_nees;                 ///< growth since the start; from the second
                                                   ///< instant on
  std::array<std::vector<double>, 3> mps;          ///< velocity, body axes
  Eigen::Vector3d velocity_mean, velocity_square;  ///< over the run, m/s and its square
};

/// A method with the vehicle model that it uses.
struct Contender {
  Method method;
  const hydrodynamics::Model* model;
};

/// Runs all contenders on the same sensors, those of `run`.
std::vector<VelocityTrial> velocity_trial(const RecordedMission& mission,
                                          const VelocityErrors& errors, bool gaps,
                                          std::uint64_t seed, std::size_t run,
                                          std::span<const Contender> contenders);

/// The same for the runs `run`, `run` + 1, ... side by side: one element of `contenders` for each,
/// with the same methods. There are at most as many as the registers hold.
std::vector<std::vector<VelocityTrial>> velocity_trials(
    const RecordedMission& mission, const VelocityErrors& errors, bool gaps, std::uint64_t seed,
    std::size_t run, std::span<const std::vector<Contender>> contenders,
    const Registers& registers);

}  // namespace drydock::study

#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "estimators/frame/geodetic.hpp"
#include "estimators/hydrodynamics/vehicle.hpp"

/// One truth of the velocity study, sailed once and kept for all runs: the output of error-free
/// sensors at their rates.
namespace drydock::study {

enum class Hull { symmetric, asymmetric };

/// 100 Hz: the interval that ends at the sample's time.
struct MissionSample {
  Eigen::Vector3d angle, velocity;  ///< integrals of angular rate, rad, and specific force, m/s
  double height_m;
  hydrodynamics::Control control;  ///< in the middle of the interval
};

/// 10 Hz: the truth at the end of a navigation step.
struct MissionInstant {
  frame::Position position;
  Eigen::Vector3d velocity_ned;  ///< over ground, m/s
  Eigen::Quaterniond body_to_ned;
  double speed_through_water;  ///< m/s

  Eigen::Vector3d velocity_body() const { return body_to_ned.conjugate() * velocity_ned; }
};

struct RecordedMission {
  static constexpr double sample_s = 0.01;
  static constexpr std::size_t samples_a_step = 10;

  std::vector<MissionSample> samples;    ///< samples_a_step for each step
  std::vector<MissionInstant> instants;  ///< the start, then the end of each step

  std::size_t steps() const { return instants.size() - 1; }
};

/// The vehicle that sails the mission. The estimators know it with errors of its coefficients.
hydrodynamics::Vehicle mission_vehicle(Hull hull);

/// The paper's 5.5 h (rig_config/missions/velocity-paper.toml), or the first `duration_s`, in a
/// steady current (north, east), m/s.
RecordedMission record_velocity_mission(Hull hull, const Eigen::Vector2d& current,
                                        double duration_s = 1e9);

}  // namespace drydock::study

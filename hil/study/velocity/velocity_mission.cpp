#include "hil/study/velocity/velocity_mission.hpp"

#include <algorithm>
#include <string>

#include "estimators/vehicle/vehicle.hpp"
#include "hil/motion/vehicle/vehicle_trajectory.hpp"
#include "hil/sensor/increments.hpp"
#include "hil/study/velocity/velocity_files.hpp"
#include "rig_config/load.hpp"

namespace drydock::study {

using Eigen::Vector3d;
using measurement::Stamp;

namespace {

rig_config::VehicleConfig vehicle_config(Hull hull) {
  return rig_config::load_vehicle_text(velocity_vehicle_text(hull), "vehicle").value();
}

/// The mission names a vehicle file, which cannot be read here. This sets the vehicle instead.
rig_config::MissionConfig mission_config(Hull hull, const Eigen::Vector2d& current) {
  std::string text(velocity_mission_text());
  const auto line = text.find("\nvehicle = ");
  if (line != std::string::npos) text.erase(line, text.find('\n', line + 1) - line);
  auto mission = rig_config::load_mission_text(text, "mission").value();
  mission.vehicle = vehicle_config(hull);
  mission.ocean.current = {{.depth_m = 0, .velocity_ned_mps = {current.x(), current.y(), 0}}};
  return mission;
}

MissionInstant instant(const motion::Truth& truth) {
  return {{truth.latitude_rad, truth.longitude_rad, truth.height_m},
          truth.velocity_ned,
          truth.body_to_ned,
          (truth.velocity_ned - truth.current_ned).norm()};
}

}  // namespace

hydrodynamics::Vehicle mission_vehicle(Hull hull) {
  return vehicle::dimensional(vehicle_config(hull));
}

RecordedMission record_velocity_mission(Hull hull, const Eigen::Vector2d& current,
                                        double duration_s) {
  constexpr std::chrono::nanoseconds sample_ns{10'000'000};
  const auto mission = mission_config(hull, current);
  const double advance = mission.vehicle->propeller.advance_m;
  const motion::VehicleTrajectory trajectory(mission, Stamp{});
  sensor::IncrementIntegrator imu(trajectory, Stamp{});

  RecordedMission record;
  const double end_s = std::min(duration_s, measurement::seconds(trajectory.end() - Stamp{}));
  const auto steps = static_cast<std::size_t>(
      end_s / (RecordedMission::sample_s * RecordedMission::samples_a_step));
  record.samples.reserve(steps * RecordedMission::samples_a_step);
  record.instants.reserve(steps + 1);
  record.instants.push_back(instant(trajectory.at(Stamp{})));
  Stamp now{};
  for (std::size_t step = 0; step < steps; ++step) {
    motion::Truth truth;
    for (std::size_t i = 0; i < RecordedMission::samples_a_step; ++i) {
      const auto middle = trajectory.at(now + sample_ns / 2);
      now += sample_ns;
      const auto [angle, velocity] = imu.until(now);
      truth = trajectory.at(now);
      record.samples.push_back({angle,
                                velocity,
                                truth.height_m,
                                {.delta_r = middle.rudder_rad,
                                 .delta_s = middle.stern_plane_rad,
                                 .delta_b = middle.bow_plane_rad,
                                 .u_c = advance * middle.propeller_radps}});
    }
    record.instants.push_back(instant(truth));
  }
  return record;
}

}  // namespace drydock::study

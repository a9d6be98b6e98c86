#include "hil/motion/ordered/ordered_trajectory.hpp"

#include <numeric>

#include "hil/motion/vehicle/vehicle_trajectory.hpp"

namespace drydock::motion {

OrderedTrajectory::OrderedTrajectory(const rig_config::MissionConfig& mission, Stamp start)
    : orders_(mission.vehicle.value(), mission.speed_mps, start),
      voyage_(mission, orders_, Edges::closed),
      start_(start),
      legs_s_(std::accumulate(
          mission.legs.begin(), mission.legs.end(), 0.0,
          [](double sum, const rig_config::LegConfig& leg) { return sum + leg.duration_s; })) {
  if (!mission.legs.empty()) MissionHelm(mission).check_plan(mission, ocean());
}

Truth OrderedTrajectory::at(Stamp time) const { return truth_at(voyage_, start_, time); }

Stamp OrderedTrajectory::end() const { return start_ + measurement::from_seconds(legs_s_); }

}  // namespace drydock::motion

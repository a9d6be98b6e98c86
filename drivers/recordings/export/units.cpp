#include "drivers/recordings/export/units.hpp"

#include <array>

namespace drydock::exporting {

namespace {

struct Entry {
  std::string_view type, field, unit;  ///< for everything below `field`
};

constexpr std::string_view rate = "rad/s", speed = "m/s", acceleration = "m/s2";

constexpr std::array entries{
    Entry{"sensor_msgs/msg/Imu", "angular_velocity", rate},
    Entry{"sensor_msgs/msg/Imu", "linear_acceleration", acceleration},
    Entry{"sensor_msgs/msg/NavSatFix", "latitude", "deg"},
    Entry{"sensor_msgs/msg/NavSatFix", "longitude", "deg"},
    Entry{"sensor_msgs/msg/NavSatFix", "altitude", "m"},
    Entry{"sensor_msgs/msg/NavSatFix", "position_covariance", "m2"},
    Entry{"sensor_msgs/msg/FluidPressure", "fluid_pressure", "Pa"},
    Entry{"sensor_msgs/msg/FluidPressure", "variance", "Pa2"},
    Entry{"sensor_msgs/msg/Temperature", "temperature", "degC"},
    Entry{"sensor_msgs/msg/Temperature", "variance", "degC2"},
    Entry{"geometry_msgs/msg/TwistWithCovarianceStamped", "twist.twist.linear", speed},
    Entry{"geometry_msgs/msg/TwistWithCovarianceStamped", "twist.twist.angular", rate},
    Entry{"nav_msgs/msg/Odometry", "pose.pose.position", "m"},
    Entry{"nav_msgs/msg/Odometry", "twist.twist.linear", speed},
    Entry{"nav_msgs/msg/Odometry", "twist.twist.angular", rate},
    Entry{"marine_acoustic_msgs/msg/Dvl", "velocity", speed},
    Entry{"marine_acoustic_msgs/msg/Dvl", "velocity_covar", "m2/s2"},
    Entry{"marine_acoustic_msgs/msg/Dvl", "altitude", "m"},
    Entry{"marine_acoustic_msgs/msg/Dvl", "course_gnd", "rad"},
    Entry{"marine_acoustic_msgs/msg/Dvl", "speed_gnd", speed},
    Entry{"marine_acoustic_msgs/msg/Dvl", "sound_speed", speed},
    Entry{"marine_acoustic_msgs/msg/Dvl", "range", "m"},
    Entry{"marine_acoustic_msgs/msg/Dvl", "range_covar", "m2"},
    Entry{"marine_acoustic_msgs/msg/Dvl", "beam_velocity", speed},
    Entry{"marine_acoustic_msgs/msg/Dvl", "beam_velocity_covar", "m2/s2"},
    Entry{"drydock/msg/Depth", "depth", "m"},
    Entry{"drydock/msg/Depth", "pressure", "Pa"},
    Entry{"drydock/msg/Depth", "temperature", "K"},
    Entry{"drydock/msg/Depth", "altitude", "m"},
    Entry{"drydock/msg/BottomTrack", "velocity", speed},
    Entry{"drydock/msg/BottomTrack", "error_velocity", speed},
    Entry{"drydock/msg/BottomTrack", "altitude", "m"},
    Entry{"drydock/msg/BottomTrack", "range", "m"},
    Entry{"drydock/msg/BottomTrack", "heading", "rad"},
    Entry{"drydock/msg/BottomTrack", "pitch", "rad"},
    Entry{"drydock/msg/BottomTrack", "roll", "rad"},
    Entry{"drydock/msg/BottomTrack", "sound_speed", speed},
    Entry{"drydock/msg/BottomTrack", "velocity_covariance", "m2/s2"},
    Entry{"drydock/msg/BottomTrack", "figure_of_merit", speed},
    Entry{"drydock/msg/WaterSpeed", "longitudinal", speed},
    Entry{"drydock/msg/WaterSpeed", "transverse", speed},
    Entry{"drydock/msg/WaterSpeed", "distance", "m"},
    Entry{"drydock/msg/WaterSpeed", "sigma", speed},
    Entry{"drydock/msg/GnssFix", "latitude", "rad"},
    Entry{"drydock/msg/GnssFix", "longitude", "rad"},
    Entry{"drydock/msg/GnssFix", "ellipsoidal_height", "m"},
    Entry{"drydock/msg/GnssFix", "mean_sea_level_height", "m"},
    Entry{"drydock/msg/GnssFix", "velocity_ned", speed},
    Entry{"drydock/msg/GnssFix", "horizontal_accuracy", "m"},
    Entry{"drydock/msg/GnssFix", "vertical_accuracy", "m"},
    Entry{"drydock/msg/GnssFix", "speed_accuracy", speed},
    Entry{"drydock/msg/GnssFix", "ground_speed", speed},
    Entry{"drydock/msg/GnssFix", "course", "rad"},
    Entry{"drydock/msg/ActuatorState", "rudder", "rad"},
    Entry{"drydock/msg/ActuatorState", "stern_plane", "rad"},
    Entry{"drydock/msg/ActuatorState", "bow_plane", "rad"},
    Entry{"drydock/msg/ActuatorState", "propeller", rate},
    Entry{"drydock/msg/Attitude", "heading", "rad"},
    Entry{"drydock/msg/Attitude", "deviation", "rad"},
    Entry{"drydock/msg/Attitude", "variation", "rad"},
    Entry{"drydock/msg/Attitude", "true_heading", "rad"},
    Entry{"drydock/msg/Attitude", "roll", "rad"},
    Entry{"drydock/msg/Attitude", "pitch", "rad"},
    Entry{"drydock/msg/Attitude", "rate_of_turn", rate},
};

/// "velocity" is above "velocity.x" and "velocity[0]", not above "velocity_covar".
bool is_above(std::string_view field, std::string_view path) {
  return path.starts_with(field) &&
         (path.size() == field.size() || path[field.size()] == '.' || path[field.size()] == '[');
}

}  // namespace

std::string_view unit_of(std::string_view type, std::string_view field) {
  if (field.ends_with(".sec")) return "s";
  if (field.ends_with(".nanosec") || field.ends_with(".nanoseconds")) return "ns";
  for (const Entry& entry : entries)
    if (entry.type == type && is_above(entry.field, field)) return entry.unit;
  return {};
}

}  // namespace drydock::exporting

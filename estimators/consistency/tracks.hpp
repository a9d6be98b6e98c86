#pragma once

#include <vector>

#include "drivers/measurement/measurement.hpp"
#include "estimators/consistency/sensor.hpp"
#include "estimators/consistency/track.hpp"

namespace drydock::consistency {

/// An angle without jumps at +-180 degrees.
class Unwrapped {
 public:
  double next(double angle_rad);

 private:
  double last_ = 0;
};

struct DvlTracks {
  DvlTracks(std::uint16_t index, const Sensor& sensor);
  std::uint16_t device;
  Sensor sensor;
  Track<3> velocity;  ///< m/s, body, at the DVL
  Track<1> heading;   ///< rad, unwrapped, of the head
  Track<3> down;      ///< the direction of gravity, body, from the head's own tilts
  Unwrapped unwrapped;
  Track<1> depth;  ///< m, as the head says; without a sensor it says one depth for ever
  std::optional<double> told_depth_m{};
  Stamp depth_changed{};
  /// The head's depth; empty while it does not change: the head may have no sensor.
  std::optional<double> living_depth(Stamp at) const;
};

struct LogTracks {
  LogTracks(std::uint16_t index, const Sensor& sensor);
  std::uint16_t device;
  Sensor sensor;
  Track<2> speed;       ///< m/s, body x and y
  bool across = false;  ///< the log tells y
};

struct GnssTracks {
  GnssTracks(std::uint16_t index, const Sensor& sensor);
  std::uint16_t device;
  Sensor sensor;
  Track<2> velocity;  ///< m/s, north and east
  Track<2> place;     ///< m, north and east of the first position, along the Earth
  Eigen::Vector2d moved_m = Eigen::Vector2d::Zero();
  std::optional<measurement::Geodetic> last{};
  double speed_mps = 0;  ///< of the last fix that told it, up and down as well
};

struct DepthTracks {
  DepthTracks(std::uint16_t index, const Sensor& sensor);
  std::uint16_t device;
  Sensor sensor;
  Track<1> depth;  ///< m
};

struct ActuatorTracks {
  ActuatorTracks(std::uint16_t index, const Sensor& sensor);
  std::uint16_t device;
  bool of_thruster;
  Track<1> rudder;  ///< rad
  Track<1> shaft;   ///< rad/s
};

struct AttitudeTracks {
  AttitudeTracks(std::uint16_t index, const Sensor& sensor);
  std::uint16_t device;
  Track<1> heading;  ///< rad, unwrapped
  Track<2> tilt;     ///< rad, roll and pitch
  Track<1> turn;     ///< rad/s
  Unwrapped unwrapped;
};

void take(DvlTracks& tracks, const measurement::BottomVelocity& sample);
void take(LogTracks& tracks, const measurement::WaterSpeed& sample);
void take(GnssTracks& tracks, const measurement::GnssFix& fix);
void take(DepthTracks& tracks, const measurement::DepthSample& sample);
void take(ActuatorTracks& tracks, const measurement::ActuatorState& state);
void take(AttitudeTracks& tracks, const measurement::AttitudeSample& sample);

}  // namespace drydock::consistency

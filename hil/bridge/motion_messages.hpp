#pragma once

#include <optional>

#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/mavlink/mavlink_messages.hpp"
#include "hil/bridge/body_motion.hpp"

/// What a DVL measured, as MAVLink says it. Times are those of validity, of the bench's clock.
namespace drydock::bridge {

/// The motion of the interval that ends with this ping.
wire::mavlink::VisionPositionDelta position_delta(const measurement::BottomVelocity& ping,
                                                  const Moved& moved);

/// The velocity of this ping, with its covariance, and the mean rates of the interval. A DVL knows
/// neither position nor attitude: both are NaN. `ping` has a velocity.
wire::mavlink::Odometry odometry(const measurement::BottomVelocity& ping, const Moved& moved);

/// One standard deviation of each component, m/s: as the covariance says, else the figure of merit.
std::optional<double> sigma_of(const measurement::BottomVelocity& ping);

/// 0 to 100 for a velocity with this standard deviation, m/s. ArduPilot's EKF3 reads it back so, if
/// its parameters are the default: 100 is EK3_VIS_VERR_MIN, 0.1 m/s; 0 is EK3_VIS_VERR_MAX, 0.9.
double confidence_of(double sigma_mps);

}  // namespace drydock::bridge

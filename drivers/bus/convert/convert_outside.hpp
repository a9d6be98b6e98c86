#pragma once

#include "drivers/bus/message_types.hpp"
#include "drivers/bus/outside_values.hpp"

/// Reads estimates of other programs. Axes are REP-103's: east-north-up, body forward-left-up.
/// False: the content cannot be an estimate.
namespace drydock::bus {

bool read(OutsideValues& values, const ImuMessage& message);
bool read(OutsideValues& values, const OdometryMessage& message);
bool read(OutsideValues& values, const PoseMessage& message);
/// In the frame `map`, `odom`, `world`, or one that ends with `_enu`: a velocity in the body says
/// nothing without an attitude.
bool read(OutsideValues& values, const TwistMessage& message);
bool read(OutsideValues& values, const NavSatFixMessage& message);

}  // namespace drydock::bus

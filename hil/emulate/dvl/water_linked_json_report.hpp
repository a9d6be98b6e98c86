#pragma once

#include "drivers/wire/dvl/water_linked_json_messages.hpp"
#include "hil/sensor/dvl.hpp"

namespace drydock::emulate {

/// The beams of a Water Linked A50 as they stand on the unit: transducers 0 to 3 at +135, -135, -45
/// and +45 degrees from ahead.
sensor::JanusHead head_with_a50s_beams();

/// What the DVL makes of one ping.
struct PingReport {
  std::array<sensor::DvlPing::Beam, 4> beams;
  std::optional<Eigen::Vector3d> velocity;  ///< m/s, DVL's axes, with its errors; empty: no lock
  Eigen::Vector3d error = Eigen::Vector3d::Zero();  ///< m/s: the errors in it, not in the beams
  double turned_rad = 0;                            ///< the mounting rotation that the DVL applies
};

/// Velocity, accuracy and transducers; times are left empty. The covariance is that of a least
/// squares solution over the beams that echo, the figure of merit the root of its largest
/// eigenvalue. The beams' velocities agree with the velocity.
wire::water_linked_json::VelocityReport json_report(const PingReport& of,
                                                    const sensor::JanusHead& head);

}  // namespace drydock::emulate

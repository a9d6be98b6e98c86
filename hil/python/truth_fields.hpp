#pragma once

#include "drivers/wire/fields.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::motion {

/// Names of the truth's values in tables. Angles are in degrees.
template <class Field>
void visit_fields(const Truth& t, Field&& field) {
  using wire::degrees;
  field("at_ns", t.at.time_since_epoch().count());
  field("latitude_deg", degrees(t.latitude_rad));
  field("longitude_deg", degrees(t.longitude_rad));
  field("height_m", t.height_m);
  field("roll_deg", degrees(t.roll_rad));
  field("pitch_deg", degrees(t.pitch_rad));
  field("heading_deg", degrees(t.yaw_rad));
  field("velocity_body_mps", t.velocity_body);
  field("velocity_ned_mps", t.velocity_ned);
  field("specific_force_mps2", t.specific_force);
  field("angular_rate_degps", Eigen::Vector3d(t.angular_rate * degrees(1)));
  field("current_ned_mps", t.current_ned);
  field("bed_depth_m", t.bed_depth_m);
  field("rudder_deg", degrees(t.rudder_rad));
  field("stern_plane_deg", degrees(t.stern_plane_rad));
  field("bow_plane_deg", degrees(t.bow_plane_rad));
  field("propeller_radps", t.propeller_radps);
}

}  // namespace drydock::motion

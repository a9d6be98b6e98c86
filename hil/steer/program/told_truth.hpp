#pragma once

#include "drivers/measurement/units.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::steer {

/// The truth as a program that steers may ask for it.
struct ToldTruth {
  const motion::Truth& truth;
};

template <class Field>
void visit_fields(const ToldTruth& told, Field&& field) {
  const motion::Truth& t = told.truth;
  constexpr double degrees = units::degrees_per_radian;
  field("latitude_deg", t.latitude_rad * degrees);
  field("longitude_deg", t.longitude_rad * degrees);
  field("height_m", t.height_m);
  field("roll_deg", t.roll_rad * degrees);
  field("pitch_deg", t.pitch_rad * degrees);
  field("heading_deg", t.yaw_rad * degrees);
  field("velocity_ned_mps", t.velocity_ned);
  field("velocity_body_mps", t.velocity_body);
  field("rate_body_degps", Eigen::Vector3d(t.rate_body * degrees));
  field("current_ned_mps", t.current_ned);
  field("bed_depth_m", t.bed_depth_m);
}

}  // namespace drydock::steer

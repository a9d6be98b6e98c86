#include "drivers/wire/dvl/pd0_velocity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "drivers/wire/fields.hpp"

namespace drydock::wire::testing {
namespace pd0_velocity_test {

using Vector = std::array<double, 3>;

constexpr double heading = 0.7, pitch = 0.12, roll = -0.2;  // Euler angles of the hull, rad
constexpr Vector body{1.6, -0.3, 0.15};                     // FRD, m/s

/// Rotates a body vector into north, east, down by yaw, pitch, roll (3-2-1).
Vector to_ned(const Vector& v, double yaw_rad, double pitch_rad, double roll_rad) {
  const auto [x, y, z] = v;
  const double y1 = y * std::cos(roll_rad) - z * std::sin(roll_rad);
  const double z1 = y * std::sin(roll_rad) + z * std::cos(roll_rad);
  const double x2 = x * std::cos(pitch_rad) + z1 * std::sin(pitch_rad);
  const double z2 = z1 * std::cos(pitch_rad) - x * std::sin(pitch_rad);
  return {x2 * std::cos(yaw_rad) - y1 * std::sin(yaw_rad),
          x2 * std::sin(yaw_rad) + y1 * std::cos(yaw_rad), z2};
}

/// An ensemble whose pitch sensor reads the tilt of the bow axis, like that of the instrument.
Pd0Ensemble ensemble(DvlFrame frame, std::array<std::optional<double>, 4> velocity) {
  Pd0Ensemble e;
  e.fixed.frame = frame;
  e.fixed.tilts_used = true;
  e.fixed.beam_angle_rad = radians(30);
  e.variable.heading_rad = heading;
  e.variable.pitch_rad = std::atan(std::tan(pitch) / std::cos(roll));
  e.variable.roll_rad = roll;
  e.bottom_track.emplace().velocity_mps = velocity;
  return e;
}

void expect_body(const Pd0Ensemble& e, const Vector& expected = body) {
  const auto v = velocity_frd(e);
  ASSERT_TRUE(v);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR((*v)[i], expected[i], 1e-12) << "axis " << i;
}

/// Velocities of the bed along the beams (towards the transducer), with reversed sign. The beams
/// point down and outwards: 1 to port, 2 to starboard, 3 to the bow, 4 to the stern. The beams of a
/// concave head cross: each points to the other side.
std::array<std::optional<double>, 4> along_beams(const Vector& frd, double angle_deg = 30,
                                                 bool convex = true) {
  const double s = std::sin(radians(angle_deg)) * (convex ? 1 : -1);
  const double c = std::cos(radians(angle_deg));
  const std::array<Vector, 4> outwards{Vector{0, -s, c}, {0, s, c}, {s, 0, c}, {-s, 0, c}};
  std::array<std::optional<double>, 4> along;
  for (std::size_t i = 0; i < 4; ++i) {
    // If the vehicle moves towards the bed along a beam, the bed moves towards the transducer. With
    // the reversed sign the value is negative.
    along[i] = -(frd[0] * outwards[i][0] + frd[1] * outwards[i][1] + frd[2] * outwards[i][2]);
  }
  return along;
}

TEST(Pd0Velocity, InstrumentAxesAreStarboardBowMast) {
  expect_body(ensemble(DvlFrame::instrument, {-0.3, 1.6, -0.15, 0.0}));
}

TEST(Pd0Velocity, ShipAxesWithoutTiltsAreTheHulls) {
  auto e = ensemble(DvlFrame::ship, {-0.3, 1.6, -0.15, {}});
  e.fixed.tilts_used = false;
  expect_body(e);
  e.fixed.heading_alignment_rad = radians(45);  // whatever the direction of beam 3
  expect_body(e);
}

TEST(Pd0Velocity, ShipAxesWithTiltsAreTurnedBackToTheHull) {
  const Vector level = to_ned(body, 0, pitch, roll);
  expect_body(ensemble(DvlFrame::ship, {level[1], level[0], -level[2], 0.0}));
}

TEST(Pd0Velocity, TiltsAreThoseOfTheHeadWhereverItStands) {
  // Beam 3 points to starboard. Its X axis points astern, so the hull's pitch is its roll.
  const Vector level = to_ned(body, 0, pitch, 0);
  auto e = ensemble(DvlFrame::ship, {level[1], level[0], -level[2], 0.0});
  e.fixed.heading_alignment_rad = radians(90);
  e.variable.pitch_rad = 0.0;
  e.variable.roll_rad = pitch;
  expect_body(e);
}

TEST(Pd0Velocity, EarthAxesAreTurnedBackToTheHull) {
  const Vector ned = to_ned(body, heading, pitch, roll);
  expect_body(ensemble(DvlFrame::earth, {ned[1], ned[0], -ned[2], 0.0}));
}

TEST(Pd0Velocity, BeamsFollowTheJanusGeometry) {
  expect_body(ensemble(DvlFrame::beam, along_beams(body)));
}

TEST(Pd0Velocity, TheBeamsOfAConcaveHeadCross) {
  auto e = ensemble(DvlFrame::beam, along_beams(body, 30, false));
  e.fixed.convex = false;
  expect_body(e);
  e.fixed.three_beam = true;
  for (auto& beam : e.bottom_track->velocity_mps) {
    const auto kept = std::exchange(beam, std::nullopt);
    expect_body(e);
    beam = kept;
  }
}

TEST(Pd0Velocity, AnyBeamAngleThatTheInstrumentTells) {
  for (const double angle_deg : {15.0, 20.0, 25.0}) {
    SCOPED_TRACE(angle_deg);
    auto e = ensemble(DvlFrame::beam, along_beams(body, angle_deg));
    e.fixed.beam_angle_rad = radians(angle_deg);
    expect_body(e);
  }
}

TEST(Pd0Velocity, BeamsAreTurnedToTheBowByTheAlignment) {
  // Beam 3 is 45 degrees to starboard of the bow, the usual mounting of a head.
  const double q = std::sqrt(0.5);
  const Vector in_head{q * (body[0] + body[1]), q * (body[1] - body[0]), body[2]};
  auto e = ensemble(DvlFrame::beam, along_beams(in_head));
  e.fixed.heading_alignment_rad = radians(45);
  expect_body(e);
}

TEST(Pd0Velocity, OneBadBeamIsBridgedWhereThreeAreAllowed) {
  for (std::size_t bad = 0; bad < 4; ++bad) {
    SCOPED_TRACE(bad);
    auto beams = along_beams(body);
    beams[bad].reset();
    auto e = ensemble(DvlFrame::beam, beams);
    EXPECT_FALSE(velocity_frd(e));
    e.fixed.three_beam = true;
    expect_body(e);
    e.bottom_track->velocity_mps[bad ^ 1].reset();
    EXPECT_FALSE(velocity_frd(e)) << "two bad beams";
  }
}

TEST(Pd0Velocity, AlignmentTurnsTheInstrumentToTheBow) {
  // Beam 3 is 90 degrees to starboard: its X axis points astern, its Y axis to starboard.
  auto e = ensemble(DvlFrame::instrument, {-1.6, -0.3, -0.15, 0.0});
  e.fixed.heading_alignment_rad = radians(90);
  expect_body(e);
}

TEST(Pd0Velocity, LevelAlignedEarthVelocityNeedsOnlyTheShipsHeading) {
  // The heading output refers to the ship, whatever the direction of beam 3.
  const Vector ned = to_ned(body, heading, 0, 0);
  auto e = ensemble(DvlFrame::earth, {ned[1], ned[0], -ned[2], 0.0});
  e.variable.pitch_rad = e.variable.roll_rad = 0.0;
  e.fixed.heading_alignment_rad = radians(45);
  expect_body(e);
}

TEST(Pd0Velocity, HighResolutionCountsBeforeBottomTrack) {
  auto e = ensemble(DvlFrame::instrument, {-0.3, 1.6, -0.15, 0.0});
  e.high_resolution.emplace().bottom_velocity_mps = {-0.30004, 1.60003, {}, 0.00002};
  expect_body(e, {1.60003, -0.30004, 0.15});
  EXPECT_EQ(finest_velocity(e)[3], 0.00002);
  e.bottom_track->velocity_mps[0].reset();
  EXPECT_FALSE(velocity_frd(e)) << "bottom track calls it bad";
  e.bottom_track.reset();
  e.high_resolution->bottom_velocity_mps[2] = -0.15001;
  expect_body(e, {1.60003, -0.30004, 0.15001});
}

TEST(Pd0Velocity, NothingComesOfBadVelocitiesOrMissingAngles) {
  EXPECT_FALSE(velocity_frd(ensemble(DvlFrame::ship, {0.1, {}, 0.1, 0.0})));
  auto no_heading = ensemble(DvlFrame::earth, {0.1, 0.1, 0.1, 0.0});
  no_heading.variable.heading_rad.reset();
  EXPECT_FALSE(velocity_frd(no_heading));
  auto no_roll = ensemble(DvlFrame::ship, {0.1, 0.1, 0.1, 0.0});
  no_roll.variable.roll_rad.reset();
  EXPECT_FALSE(velocity_frd(no_roll));
  auto no_angle = ensemble(DvlFrame::beam, {0.1, 0.1, 0.1, 0.1});
  no_angle.fixed.beam_angle_rad.reset();
  EXPECT_FALSE(velocity_frd(no_angle));
  auto upwards = ensemble(DvlFrame::instrument, {0.1, 0.1, 0.1, 0.1});
  upwards.fixed.faces_up = true;
  EXPECT_FALSE(velocity_frd(upwards)) << "its own axes do not see the bed";
  EXPECT_FALSE(velocity_frd(Pd0Ensemble{}));
}

}  // namespace pd0_velocity_test
}  // namespace drydock::wire::testing

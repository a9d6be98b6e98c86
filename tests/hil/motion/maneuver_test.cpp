#include "hil/motion/maneuver/maneuver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/estimators/hydrodynamics/support.hpp"

/// Standard manoeuvres of the NPS AUV II at 1500 rpm. The expected figures come from another
/// program's model of the same vehicle (npsauv.m of the Marine Systems Simulator, corrected).
namespace drydock::motion {
namespace maneuver_test {

using hydrodynamics::test::nps_file;

constexpr double degree = std::numbers::pi / 180;
constexpr double cruise_mps = 0.012 * 50 * std::numbers::pi;

struct Sailed {
  Track track;
  std::vector<Figure> figures;

  double value(const std::string& name) const {
    for (const Figure& figure : figures)
      if (figure.name == name) return figure.value.value();
    throw std::out_of_range(name);
  }
};

Sailed sailed(ManeuverKind kind, std::optional<double> deflection_deg = {}) {
  Maneuver m;
  m.kind = kind;
  m.speed_mps = cruise_mps;
  if (deflection_deg) m.deflection_rad = *deflection_deg * degree;
  Sailed result{sail(with_ideal_actuators(nps_file()), m), {}};
  result.figures = figures(kind, result.track);
  return result;
}

TEST(TurningCircle, OfTenDegreesIsAsWideAsAnotherProgramsOne) {
  const auto circle = sailed(ManeuverKind::turning_circle, 10);
  EXPECT_NEAR(circle.value("steady turning diameter"), 2 * 29.46, 0.6);
  EXPECT_NEAR(circle.value("steady rate of turn"), -3.189, 0.13) << "positive rudder: to port";
  EXPECT_NEAR(circle.value("steady speed"), std::hypot(1.6293, 0.1845), 0.011);
  EXPECT_NEAR(circle.value("steady roll"), 2.04, 0.11);
  EXPECT_NEAR(circle.track.back().state[11], -540 * degree, 0.02);
}

TEST(TurningCircle, IsSoSteadyThatItsDiameterIsThatOfItsPath) {
  const auto circle = sailed(ManeuverKind::turning_circle, 10);
  double west = 0, east = -1e9;  // the last full turn
  for (const auto& point : circle.track) {
    if (point.state[11] > -180 * degree) continue;
    west = std::min(west, point.state[7]);
    east = std::max(east, point.state[7]);
  }
  EXPECT_NEAR(circle.value("steady turning diameter"), east - west, 0.5);
}

TEST(TurningCircle, ToPortAndToStarboardMirrorEachOther) {
  const auto port = sailed(ManeuverKind::turning_circle, 15),
             starboard = sailed(ManeuverKind::turning_circle, -15);
  for (const char* name : {"advance", "transfer", "tactical diameter", "time to 360 deg"})
    EXPECT_NEAR(port.value(name), starboard.value(name), 1e-9) << name;
  EXPECT_NEAR(port.value("steady drift angle"), -starboard.value("steady drift angle"), 1e-9);
}

TEST(Zigzag, OfTenTenSwingsAsFarAsInAnotherProgramsRun) {
  const auto zigzag = sailed(ManeuverKind::zigzag);
  double most = 0, least = 0;
  for (const auto& point : zigzag.track) {
    most = std::max(most, point.state[11] / degree);
    least = std::min(least, point.state[11] / degree);
  }
  EXPECT_NEAR(most, 12.45, 0.01);
  EXPECT_NEAR(least, -12.44, 0.01);
  // A reversal comes up to one step of 0.02 s late: 0.07 deg.
  EXPECT_NEAR(zigzag.value("second overshoot"), 2.45, 0.07);
  EXPECT_NEAR(zigzag.value("third overshoot"), 2.44, 0.07);
}

TEST(Spiral, OfAVehicleThatHoldsItsCourseHasNoLoop) {
  const auto spiral = sailed(ManeuverKind::spiral);
  EXPECT_NEAR(spiral.value("rate of turn, rudder amidships"), 0, 0.01);
  EXPECT_LT(spiral.value("height of the loop"), 0.02);
  const auto points = spiral_points(spiral.track);
  ASSERT_EQ(points.size(), 21u);
  EXPECT_NEAR(points.front().rudder_rad, 20 * degree, 1e-12);
  EXPECT_NEAR(points[10].rudder_rad, -20 * degree, 1e-12);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(points[i].rate_of_turn_radps, -points[10 - i].rate_of_turn_radps, 0.02 * degree);
}

TEST(Dive, ReversesAtItsPitchAndEndsLevel) {
  const auto dive = sailed(ManeuverKind::dive);
  double steepest = 0, deepest = 0;
  for (const auto& point : dive.track) {
    steepest = std::min(steepest, point.state[10]);
    deepest = std::max(deepest, point.state[8]);
  }
  EXPECT_NEAR(dive.value("pitch overshoot"), -steepest / degree - 10, 0.3);
  EXPECT_NEAR(dive.value("depth gained to reversal") + dive.value("depth overshoot"), deepest,
              1e-9);
  EXPECT_GT(dive.value("depth overshoot"), 0);
  EXPECT_NEAR(dive.track.back().state[8], deepest, 0.01);
}

TEST(Maneuver, OfWhichNothingWasReachedHasNoFigures) {
  const auto vehicle = nps_file();
  const Track track = sail(vehicle, cruise_mps, 12, [](double t, const auto&) {
    return std::optional(Command{t < 10 ? 0 : 0.1, 0, 0, cruise_mps});
  });
  for (const Figure& figure : figures(ManeuverKind::turning_circle, track))
    EXPECT_FALSE(figure.value) << figure.name;
  const Track straight = sail(vehicle, cruise_mps, 12, [](double, const auto&) {
    return std::optional(Command{0, 0, 0, cruise_mps});
  });
  EXPECT_TRUE(figures(ManeuverKind::zigzag, straight).empty());
}

TEST(Maneuver, ASlowRudderWidensTheTurnAtItsBegin) {
  Maneuver m{ManeuverKind::turning_circle, cruise_mps, 20 * degree, 10 * degree};
  const auto slow = figures(m.kind, sail(nps_file(), m));
  const auto fast = figures(m.kind, sail(with_ideal_actuators(nps_file()), m));
  ASSERT_EQ(slow[0].name, "advance");
  // The rudder takes 8 s at 2.5 deg/s. Half of this time is lost, minus its effect on the way.
  EXPECT_NEAR(*slow[0].value - *fast[0].value, 4 * cruise_mps, 2);
}

TEST(Zigzag, ToTheOtherSideFirstIsTheMirrorImage) {
  const auto port = sailed(ManeuverKind::zigzag, 10), starboard = sailed(ManeuverKind::zigzag, -10);
  ASSERT_EQ(port.track.size(), starboard.track.size());
  EXPECT_NEAR(port.track.back().state[11], -starboard.track.back().state[11], 1e-9);
  EXPECT_NEAR(port.value("third overshoot"), starboard.value("third overshoot"), 1e-9);
}

TEST(TurningCircle, OfAScheduleEndsWhereTheRudderMoves) {
  const auto steered = [](double until) {
    return sail(with_ideal_actuators(nps_file()), cruise_mps, 400, [=](double t, const auto&) {
      return std::optional(Command{t < 10 || t >= until ? 0 : 10 * degree, 0, 0, cruise_mps});
    });
  };
  const auto whole = figures(ManeuverKind::turning_circle, steered(1e9));
  const auto righted = figures(ManeuverKind::turning_circle, steered(200));
  ASSERT_EQ(whole[3].name, "steady turning diameter");
  EXPECT_NEAR(*righted[3].value, *whole[3].value, 0.01);
  EXPECT_FALSE(figures(ManeuverKind::turning_circle, steered(60))[3].value)
      << "no full circle: nothing steady";
}

TEST(Dive, OfAScheduleThatNeverLevelsOutHasNoOvershoot) {
  const Track track = sail(nps_file(), cruise_mps, 30, [](double t, const auto&) {
    return std::optional(Command{0, (t < 10 ? 0 : t < 29.9 ? 5 : -5) * degree, 0, cruise_mps});
  });
  const auto found = figures(ManeuverKind::dive, track);
  EXPECT_NEAR(*found[0].value, 19.9, 0.021);
  for (std::size_t i = 2; i < found.size(); ++i) EXPECT_FALSE(found[i].value) << found[i].name;
}

TEST(Maneuver, ThatTheVehicleCannotSailIsRefusedInOneLine) {
  const auto why = [](ManeuverKind kind, double speed, std::optional<double> deflection_deg) {
    Maneuver m;
    m.kind = kind;
    m.speed_mps = speed;
    if (deflection_deg) m.deflection_rad = *deflection_deg * degree;
    return refusal(nps_file(), m).value_or("");
  };
  EXPECT_EQ(why(ManeuverKind::zigzag, 1.9, -10), "");
  EXPECT_EQ(why(ManeuverKind::dive, 1.9, 5), "");
  EXPECT_EQ(why(ManeuverKind::turning_circle, 1.9, 25),
            "a deflection of 25 deg; allowed: to either side, not 0, up to the stop at 20 deg");
  EXPECT_NE(why(ManeuverKind::spiral, 1.9, 0), "");
  EXPECT_NE(why(ManeuverKind::dive, 1.9, -5), "");
  EXPECT_NE(why(ManeuverKind::dive, std::nan(""), 5), "");
  EXPECT_EQ(why(ManeuverKind::dive, 4, 5),
            "a speed of 4 m/s; allowed: above 0, up to 3.142 m/s, the propeller's limit");
}

TEST(Track, EndsAtTheFirstStateThatEulerAnglesCannotFollow) {
  const Track track = sail(nps_file(), 3, 600, [](double, const auto&) {
    return std::optional(Command{0, -20 * degree, 20 * degree, 3});
  });
  for (const TrackPoint& point : track) ASSERT_TRUE(point.state.allFinite()) << point.t;
  for (std::size_t i = 0; i + 1 < track.size(); ++i) ASSERT_FALSE(too_steep(track[i].state));
}

}  // namespace maneuver_test
}  // namespace drydock::motion

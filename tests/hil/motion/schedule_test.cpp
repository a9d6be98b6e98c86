#include "hil/motion/schedule.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "hil/motion/track.hpp"
#include "tests/estimators/hydrodynamics/support.hpp"
#include "tests/test_name.hpp"

/// Commands from a CSV file. Each row holds until the next.
namespace drydock::motion {
namespace schedule_test {

using hydrodynamics::test::nps_file;
using hydrodynamics::test::Table;

constexpr double degree = std::numbers::pi / 180;

std::string error_of(std::string_view text) {
  try {
    parse_schedule(text, "s.csv");
  } catch (const BadSchedule& bad) {
    return bad.what();
  }
  return "no error";
}

TEST(Schedule, EachRowHoldsUntilTheNext) {
  const auto schedule =
      parse_schedule("t,rudder,stern,bow,rpm\n0,0,0,0,1500\r\n10,10,-5,2.5,750\n\n", "s.csv");
  ASSERT_EQ(schedule.size(), 2u);
  EXPECT_DOUBLE_EQ(command_at(schedule, 0, 0.012).speed_mps, 0.012 * 50 * std::numbers::pi);
  EXPECT_EQ(command_at(schedule, 9.99, 0.012).delta_r, 0);
  const Command later = command_at(schedule, 10, 0.012);
  EXPECT_DOUBLE_EQ(later.delta_r, 10 * degree);
  EXPECT_DOUBLE_EQ(later.delta_s, -5 * degree);
  EXPECT_DOUBLE_EQ(later.delta_b, 2.5 * degree);
  EXPECT_DOUBLE_EQ(later.speed_mps, 0.012 * 25 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(command_at(schedule, 1e6, 0.012).delta_r, 10 * degree);
}

TEST(Schedule, WhatIsWrongIsToldWithItsLine) {
  EXPECT_EQ(error_of("time,rudder\n"), "s.csv:1: the header must be t,rudder,stern,bow,rpm");
  EXPECT_EQ(error_of("t,rudder,stern,bow,rpm\n0,0,x,0,1\n"), "s.csv:2: 'x' is no number");
  EXPECT_EQ(error_of("t,rudder,stern,bow,rpm\n0,0,0,0\n"),
            "s.csv:2: 5 numbers are needed: t,rudder,stern,bow,rpm");
  EXPECT_EQ(error_of("t,rudder,stern,bow,rpm\n0,0,0,0,1,2\n"),
            "s.csv:2: 5 numbers are needed: t,rudder,stern,bow,rpm");
  EXPECT_EQ(error_of("t,rudder,stern,bow,rpm\n0,0,0,0,inf\n"), "s.csv:2: 'inf' is no number");
  EXPECT_EQ(error_of("t,rudder,stern,bow,rpm\n1,0,0,0,1\n"),
            "s.csv:2: times must begin with 0 and increase");
  EXPECT_EQ(error_of("t,rudder,stern,bow,rpm\n0,0,0,0,1\n0,1,0,0,1\n"),
            "s.csv:3: times must begin with 0 and increase");
  EXPECT_EQ(error_of("t,rudder,stern,bow,rpm\n"), "s.csv: no row; the first must be at t = 0");
  EXPECT_EQ(error_of(""), "s.csv: no row; the first must be at t = 0");
}

RC_GTEST_PROP(Schedule, AnyTextIsReadOrRefused, (const std::string& rows)) {
  try {
    const auto schedule = parse_schedule("t,rudder,stern,bow,rpm\n" + rows, "s.csv");
    RC_ASSERT(schedule.front().t == 0);
  } catch (const BadSchedule&) {
  }
}

struct Case {
  const char* file;
  const char* rows;
};
class Tables : public testing::TestWithParam<Case> {};

TEST_P(Tables, OfAnotherProgramAreFollowedByTheScheduleThatMadeThem) {
  const Table table(GetParam().file);
  if (table.empty()) GTEST_SKIP() << "corpora absent: vehicle";
  const auto schedule =
      parse_schedule(std::string("t,rudder,stern,bow,rpm\n") + GetParam().rows, "s.csv");
  const auto vehicle = with_ideal_actuators(nps_file());
  const double advance = vehicle.propeller.advance_m;
  const Track track =
      sail(vehicle, advance * schedule.front().propeller_radps, table.at(table.rows() - 1, "t"),
           [&](double t, const auto&) { return std::optional(command_at(schedule, t, advance)); });
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const TrackPoint& point = track.at(10 * row);  // the rows of the table are 0.2 s apart
    ASSERT_NEAR(point.t, table.at(row, "t"), 1e-9);
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(point.state[i], table.velocity(row)[i], 1e-5);
    for (const auto& [column, i] : {std::pair{"x", 6}, {"y", 7}, {"z", 8}, {"psi", 11}})
      EXPECT_NEAR(point.state[i], table.at(row, column), 1e-5) << column << " at " << point.t;
    EXPECT_NEAR(point.control.delta_r, table.at(row, "delta_r"), 1e-9) << point.t;
    EXPECT_NEAR(point.control.delta_s, table.at(row, "delta_s"), 1e-9) << point.t;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Gh, Tables,
    testing::Values(Case{"gh_rudder_p10.csv", "0,0,0,0,1500\n10,10,0,0,1500\n"},
                    Case{"gh_rudder_m10.csv", "0,0,0,0,1500\n10,-10,0,0,1500\n"},
                    Case{"gh_stern_p3.csv", "0,0,0,0,1500\n10,0,3,0,1500\n"},
                    Case{"gh_stern_pulse_m5.csv", "0,0,0,0,1500\n10,0,-5,0,1500\n20,0,0,0,1500\n"}),
    [](const auto& one) { return drydock::test::test_name(one.param.file); });

}  // namespace schedule_test
}  // namespace drydock::motion

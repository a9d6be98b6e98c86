#include <algorithm>
#include <numbers>

#include "tests/rig_config/problems.hpp"

/// Vehicle files.
namespace drydock::rig_config::test {
namespace vehicle_file_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string smallest =
    "[vehicle]\nname = \"v\"\nlength_m = 2\nwater_density_kgm3 = 1000\nmass_kg = 100\n"
    "weight_n = 981\nbuoyancy_n = 990\nz_G_m = 0.02\nmoments_of_inertia_kgm2 = [1, 20, 30]\n"
    "[rudder]\nlimit_deg = 30\n[stern_planes]\nlimit_deg = 20\nrate_limit_degps = 90\n"
    "lag_s = 0.2\n[bow_planes]\nlimit_deg = 10\n[propeller]\nadvance_m = 0.01\n"
    "limit_rpm = 600\n[X]\nudot = -0.01\na = 1\n[Y]\nvdot = -0.01\n[Z]\nwdot = -0.01\n"
    "[K]\npdot = -0.01\n[M]\nqdot = -0.01\n[N]\nrdot = -0.01\n";

std::vector<std::string> problems_with(const std::string& line, const std::string& in_place_of) {
  std::string text = smallest;
  text.replace(text.find(in_place_of), in_place_of.size(), line);
  const auto vehicle = load_vehicle_text(text, "v.toml");
  return vehicle ? std::vector<std::string>{} : lines_of(vehicle.error());
}

TEST(VehicleFile, TheSmallestIsReadInSiUnitsWithPrimeCoefficients) {
  const auto vehicle = load_vehicle_text(smallest, "v.toml");
  ASSERT_TRUE(vehicle);
  EXPECT_EQ(vehicle->name, "v");
  EXPECT_EQ(vehicle->buoyancy_n, 990);
  EXPECT_EQ(vehicle->z_B_m, 0);
  EXPECT_THAT(vehicle->moments_of_inertia_kgm2, ElementsAre(1, 20, 30));
  EXPECT_DOUBLE_EQ(vehicle->rudder.limit_rad, std::numbers::pi / 6);
  EXPECT_EQ(vehicle->rudder.rate_limit_radps, std::nullopt);
  EXPECT_EQ(vehicle->rudder.lag_s, 0);
  EXPECT_DOUBLE_EQ(vehicle->stern_planes.rate_limit_radps.value(), std::numbers::pi / 2);
  EXPECT_EQ(vehicle->stern_planes.lag_s, 0.2);
  EXPECT_DOUBLE_EQ(vehicle->propeller.limit_radps, 20 * std::numbers::pi);
  ASSERT_EQ(vehicle->coefficients.size(), 7U);
  const auto a = std::ranges::find(vehicle->coefficients, "a", &CoefficientConfig::name);
  EXPECT_EQ(a->axis, "X");
  EXPECT_EQ(a->prime, 1);
}

TEST(VehicleFile, ACoefficientOfAnotherAxisIsAnUnknownKey) {
  EXPECT_THAT(problems_with("\"v|r|\" = -1\nudot", "udot"),
              ElementsAre(HasSubstr("v.toml:22:1: /X/v|r|: unknown key (did you mean 'vr'?), "
                                    "allowed here: a, b, c, delta_b_delta_b")));
}

TEST(VehicleFile, BarsInANameAreAllowed) {
  EXPECT_THAT(problems_with("\"v|r|\" = -1\nvdot", "vdot"), IsEmpty());
}

TEST(VehicleFile, ADimensionalValueIsOutOfRange) {
  EXPECT_THAT(problems_with("a = -579.9", "a = 1"),
              ElementsAre("v.toml:23:5: /X/a: -579.9 is out of range, allowed: -10 to 10"));
}

TEST(VehicleFile, AddedMassHasASign) {
  EXPECT_THAT(problems_with("udot = 0.01", "udot = -0.01"),
              ElementsAre("v.toml:22:8: /X/udot: 0.01 is out of range, allowed: -10 to 0"));
}

TEST(VehicleFile, WhatIsMissingIsNamed) {
  EXPECT_THAT(problems_with("", "advance_m = 0.01\n"),
              ElementsAre("v.toml:18:1: /propeller: key 'advance_m' is missing"));
  EXPECT_THAT(problems_with("", "[bow_planes]\nlimit_deg = 10\n"),
              ElementsAre("v.toml:1:1: /: key 'bow_planes' is missing"));
  EXPECT_THAT(problems_with("", "udot = -0.01\n"),
              ElementsAre("v.toml:21:1: /X: key 'udot' is missing"));
}

TEST(VehicleFile, AnotherKindOfFileIsRefused) {
  const auto vehicle = load_vehicle_text("[imu]\n", "v.toml");
  ASSERT_FALSE(vehicle);
  EXPECT_THAT(lines_of(vehicle.error()),
              ElementsAre("v.toml:1:1: /: expected a vehicle file, which has a table [vehicle]"));
}

}  // namespace vehicle_file_test
}  // namespace drydock::rig_config::test

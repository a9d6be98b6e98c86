#include "estimators/vehicle/vehicle.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "tests/estimators/hydrodynamics/support.hpp"

namespace drydock::vehicle {
namespace {

using hydrodynamics::coefficient_table;
using hydrodynamics::test::nps_file;

TEST(VehicleFiles, TheSchemaKnowsTheCoefficientsOfTheEquationsAndNoOthers) {
  std::set<std::string> of_schema, of_equations;
  const auto definitions = nlohmann::json::parse(rig_config::vehicle_schema_text())["definitions"];
  for (const std::string axis : {"X", "Y", "Z", "K", "M", "N"})
    for (const auto& entry : definitions[axis]["properties"].items())
      of_schema.insert(axis + " " + entry.key());
  for (const auto& entry : coefficient_table())
    of_equations.insert(std::string(entry.axis) + " " + std::string(entry.name));
  EXPECT_EQ(of_schema, of_equations);
}

/// Names in the table of the corpora. There an `a` marks an absolute value.
std::string name_in_corpora(std::string_view name) {
  static const std::map<std::string_view, std::string> others{{"*", "star"},
                                                              {"|r|delta_r", "ardr"},
                                                              {"|q|delta_s", "aqds"},
                                                              {"delta_r", "dr"},
                                                              {"delta_s", "ds"},
                                                              {"delta_b", "db"},
                                                              {"delta_r_delta_r", "drdr"},
                                                              {"delta_s_delta_s", "dsds"},
                                                              {"delta_b_delta_b", "dbdb"},
                                                              {"v|v|", "vvR"},
                                                              {"p|p|", "pap"},
                                                              {"v|r|", "var"},
                                                              {"|w|", "aw"},
                                                              {"w|w|", "waw"},
                                                              {"w|q|", "waq"},
                                                              {"q|q|", "qaq"},
                                                              {"|w|q", "awq"},
                                                              {"r|r|", "rar"},
                                                              {"|v|r", "avr"}};
  const auto found = others.find(name);
  return found == others.end() ? std::string(name) : found->second;
}

TEST(NpsAuvFile, HasEveryCoefficientOfTheCorpora) {
  const hydrodynamics::test::Table table("gh_nps_coefficients.csv");
  if (table.empty()) GTEST_SKIP() << "corpora absent: vehicle";
  std::map<std::string, std::size_t> row_of;
  for (std::size_t i = 0; i < table.rows(); ++i)
    row_of[table.text(i, "axis") + " " + table.text(i, "name")] = i;
  const auto file = nps_file();
  const auto vehicle = dimensional(file);
  ASSERT_EQ(file.coefficients.size(), coefficient_table().size());
  for (const auto& [axis, name, prime] : file.coefficients) {
    const std::size_t row = row_of.at(axis + " " + name_in_corpora(name));
    const auto* entry = hydrodynamics::find_coefficient(axis, name);
    const double si = table.at(row, "dimensional_SI");
    EXPECT_NEAR(prime, table.at(row, "prime_value"), 1e-7 * std::abs(prime)) << axis << name;
    EXPECT_NEAR(vehicle.coefficients.*entry->member, si, 5e-10 * std::abs(si)) << axis << name;
    EXPECT_EQ(entry->length_power, table.at(row, "L_power"));
  }
  EXPECT_NEAR(vehicle.body.mass, table.at(row_of.at("body m"), "prime_value"), 1e-6);
  EXPECT_EQ(vehicle.body.z_G, 0.061);
  EXPECT_EQ(vehicle.body.moments_of_inertia, Eigen::Vector3d(2038, 13587, 13587));
  EXPECT_EQ(vehicle.body.weight, vehicle.body.buoyancy);
}

TEST(NpsAuvFile, TheAsymmetricOneDiffersInTheStarredCoefficientsAlone) {
  const std::map<std::string, double> starred{
      {"Y", 1e-3}, {"Z", -1e-3}, {"K", 1e-5}, {"M", 2e-4}, {"N", 2e-4}};
  auto plain = nps_file();
  const auto asymmetric = nps_file("nps-auv-ii-asymmetric");
  for (auto& coefficient : plain.coefficients)
    if (coefficient.name == "*") coefficient.prime = starred.at(coefficient.axis);
  ASSERT_EQ(plain.coefficients.size(), asymmetric.coefficients.size());
  for (std::size_t i = 0; i < plain.coefficients.size(); ++i) {
    EXPECT_EQ(plain.coefficients[i].name, asymmetric.coefficients[i].name);
    EXPECT_EQ(plain.coefficients[i].prime, asymmetric.coefficients[i].prime)
        << plain.coefficients[i].axis << plain.coefficients[i].name;
  }
  EXPECT_EQ(dimensional(plain).body.mass, dimensional(asymmetric).body.mass);
}

TEST(Dimensional, ACoefficientThatTheEquationsDoNotHaveIsRefused) {
  rig_config::VehicleConfig config;
  config.coefficients.push_back({"X", "vdot", 1});
  EXPECT_THROW(dimensional(config), std::invalid_argument);
}

}  // namespace
}  // namespace drydock::vehicle

#include "estimators/hydrodynamics/coefficient_table.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

namespace drydock::hydrodynamics {
namespace {

TEST(CoefficientTable, NamesEveryMemberOnce) {
  std::set<std::ptrdiff_t> places;
  std::set<std::string> names;
  const Coefficients c;
  for (const NamedCoefficient& entry : coefficient_table()) {
    places.insert(&(c.*entry.member) - &c.X_udot);
    names.insert(std::string(entry.axis) + " " + std::string(entry.name));
  }
  EXPECT_EQ(coefficient_table().size() * sizeof(double), sizeof(Coefficients));
  EXPECT_EQ(places.size(), coefficient_table().size());
  EXPECT_EQ(names.size(), coefficient_table().size());
}

/// The power of L in the unit of a prime value, from the name alone. Each angular rate and each
/// rate of change in the name adds one power; a moment adds one too.
int length_power_by_dimension(const NamedCoefficient& entry) {
  const bool moment = entry.axis == "K" || entry.axis == "M" || entry.axis == "N";
  std::string name(entry.name);
  for (const char* control : {"delta_r", "delta_s", "delta_b"})
    for (auto at = name.find(control); at != std::string::npos; at = name.find(control))
      name.erase(at, std::strlen(control));
  int power = moment ? 3 : 2;
  if (name.ends_with("dot")) {
    ++power;
    name.erase(name.size() - 3);
  }
  for (const char letter : name) power += letter == 'p' || letter == 'q' || letter == 'r';
  return power;
}

TEST(CoefficientTable, TheLengthPowerIsWhatTheDimensionAsksFor) {
  for (const NamedCoefficient& entry : coefficient_table())
    EXPECT_EQ(entry.length_power, length_power_by_dimension(entry)) << entry.axis << entry.name;
}

TEST(CoefficientTable, FindsByAxisAndName) {
  ASSERT_NE(find_coefficient("Y", "v|r|"), nullptr);
  EXPECT_EQ(find_coefficient("Y", "v|r|")->member, &Coefficients::Y_v_abs_r);
  EXPECT_EQ(find_coefficient("Y", "w|q|"), nullptr);
}

TEST(CoefficientTable, APrimeUnitIsHalfTheDensityTimesAPowerOfLength) {
  EXPECT_DOUBLE_EQ(prime_unit(3, 1000, 2), 4000);
}

}  // namespace
}  // namespace drydock::hydrodynamics

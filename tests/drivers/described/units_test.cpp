#include <fstream>

#include "rig_config/device_description/units.hpp"
#include "tests/drivers/described/support.hpp"

/// The units of wires, in SI and on the page.
namespace drydock::described::test {
namespace units_test {

TEST(DescriptionProblems, ThePageNamesEveryUnitAndEveryField) {
  std::ifstream in(DRYDOCK_SOURCE_DIR "/docs/sensors/described.md");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  for (const auto& unit : rig_config::wire_units)
    EXPECT_NE(page.find("`" + std::string(unit.name) + "`"), page.npos) << unit.name;
  for (const auto& row : wire::described::target_rows) {
    if (row.name.starts_with("covariance") || row.name.starts_with("range_")) continue;
    EXPECT_NE(page.find("`" + std::string(row.name) + "`"), page.npos) << row.name;
  }
  for (const auto& [name, text] : rig_config::built_in_descriptions())
    EXPECT_NE(page.find("| `" + std::string(name) + "` |"), page.npos) << name;
}

TEST(DescriptionProblems, UnitsHaveTheirValuesOfSi) {
  const auto si = [](std::string_view name, double figure) {
    const auto* unit = rig_config::find_unit(name);
    EXPECT_NE(unit, nullptr) << name;
    return figure * unit->factor + unit->offset;
  };
  EXPECT_DOUBLE_EQ(si("fathom", 1), 1.8288);
  EXPECT_DOUBLE_EQ(si("kn", 1), 1852.0 / 3600);
  EXPECT_NEAR(si("psi", 1), 6894.757, 5e-4);   // NIST SP 811: 6.894 757 E+03
  EXPECT_NEAR(si("inHg", 1), 3386.389, 5e-4);  // 3.386 389 E+03, conventional
  EXPECT_NEAR(si("mmHg", 1), 133.3224, 5e-5);  // 1.333 224 E+02
  EXPECT_DOUBLE_EQ(si("mH2O", 1), 9806.65);
  EXPECT_DOUBLE_EQ(si("degC", 25), 298.15);
  EXPECT_NEAR(si("degF", 212), 373.15, 1e-9);
  EXPECT_DOUBLE_EQ(si("mg", 1000), 9.80665);
  EXPECT_NEAR(si("rpm", 60), 2 * 3.14159265358979, 1e-12);
}

}  // namespace units_test
}  // namespace drydock::described::test

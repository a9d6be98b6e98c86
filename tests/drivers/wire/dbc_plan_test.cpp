#include <gtest/gtest.h>

#include "drivers/wire/dbc/catalogue.hpp"
#include "drivers/wire/dbc/plan.hpp"
#include "tests/drivers/property.hpp"
#include "tests/drivers/wire/dbc_files.hpp"

/// Frames by the plan of a message.
namespace drydock::wire::dbc {
namespace dbc_plan_test {

using Bytes8 = std::vector<std::uint8_t>;

std::string message(const std::string& signals, unsigned size = 8) {
  return "BO_ 1 m: " + std::to_string(size) + " n\n" + signals;
}
std::string signal(const std::string& name_and_bits, const std::string& scale = "(1,0)") {
  return " SG_ " + name_and_bits + " " + scale + " [0|0] \"\" n\n";
}

std::vector<Value> decoded(const std::string& text, const Bytes8& data) {
  const Plan plan(test::sound(text).messages.at(0));
  std::vector<Value> values(plan.size());
  plan.decode(data, values);
  return values;
}

/// The only signal's value.
double value(const std::string& bits, const Bytes8& data, const std::string& scale = "(1,0)") {
  return decoded(message(signal("s : " + bits, scale)), data).at(0).physical;
}

TEST(DbcPlan, MotorolaSignalsBelowAByteStandWhereTheFormatSays) {
  EXPECT_EQ(value("2|11@0-", {0x05, 0xA3}), -605);         // 101 10100011
  EXPECT_EQ(value("0|12@0+", {0x01, 0x80, 0xE0}), 0xC07);  // 1 10000000 111
  EXPECT_EQ(value("7|4@0+", {0xA5}), 0xA);
  EXPECT_EQ(value("3|4@0+", {0xA5}), 5);
}

TEST(DbcPlan, IntelSignalsGrowUpward) {
  EXPECT_EQ(value("4|8@1+", {0xA0, 0x0B}), 0xBA);
  EXPECT_EQ(value("0|64@1-", {0xFE, 255, 255, 255, 255, 255, 255, 255}), -2);
  EXPECT_EQ(value("8|16@1+", {0, 0x34, 0x12}, "(0.1,-100)"), 0x1234 * 0.1 - 100);
}

TEST(DbcPlan, AFrameCutShortGivesWhatFits) {
  const std::string text = message(signal("a : 0|8@1+") + signal("b : 15|8@0+") +
                                   signal("sel M : 24|8@1+") + signal("c m0 : 8|8@1+"));
  const auto values = decoded(text, {1, 2});
  EXPECT_TRUE(values[0].present);
  EXPECT_TRUE(values[1].present);
  EXPECT_FALSE(values[2].present);
  EXPECT_FALSE(values[3].present);  // nobody knows its selector
  for (const Value& v : decoded(text, {})) EXPECT_FALSE(v.present);
}

TEST(DbcPlan, APhysicalValueThatDoesNotFitGivesNoRawValue) {
  const Plan plan(test::sound(message(signal("s : 0|8@1-", "(0.5,10)"))).messages[0]);
  EXPECT_EQ(plan.nearest(0, 73.5)->raw, 127u);
  EXPECT_FALSE(plan.nearest(0, 74));
  EXPECT_EQ(static_cast<std::int64_t>(plan.nearest(0, -54)->raw), -128);
  EXPECT_FALSE(plan.nearest(0, -54.5));
  EXPECT_FALSE(plan.nearest(0, std::nan("")));
  EXPECT_FALSE(plan.nearest(0, INFINITY));
}

TEST(DbcPlan, EncodingKeepsTheOtherBits) {
  const Plan plan(test::sound(message(signal("s : 2|11@0-"))).messages[0]);
  std::vector<Value> values{*plan.nearest(0, -605)};
  Bytes8 data{0xF8, 0x00, 0xFF};
  plan.encode(values, data);
  EXPECT_EQ(data, (Bytes8{0xFD, 0xA3, 0xFF}));
}

TEST(DbcPlan, AnyRawValueComesBackFromAnyPlace) {
  EXPECT_TRUE(holds([] {
    const auto bits = *rc::gen::inRange(1u, 65u);
    const bool intel = *rc::gen::arbitrary<bool>();
    const auto start = *rc::gen::inRange(0u, intel ? 513 - bits : 449u);
    const auto raw = *rc::gen::arbitrary<std::uint64_t>() >> (64 - bits);
    const auto noise = *rc::gen::arbitrary<std::uint8_t>();
    const auto where = std::to_string(start) + "|" + std::to_string(bits) + "@";
    const Plan plan(
        test::sound(message(signal("s : " + where + (intel ? "1+" : "0+")), 64)).messages[0]);
    std::vector<Value> values{{raw, 0, true}};
    Bytes8 data(64, noise);
    plan.encode(values, data);
    plan.decode(data, values);
    RC_ASSERT(values[0].raw == raw);
  }));
}

constexpr const char* group_files =
    "BA_DEF_ BO_ \"VFrameFormat\" INT 0 15;\n"
    "BA_DEF_DEF_ \"VFrameFormat\" 3;\n";

std::optional<std::size_t> found(const std::string& text, const std::string& frame) {
  return Catalogue(test::sound(text + group_files)).find(wire::test::frame(frame));
}

/// BO_ with bit 31.
std::string group(std::uint32_t id, const std::string& name) {
  return "BO_ " + std::to_string(id | 0x80000000) + " " + name + ": 8 n\n";
}

TEST(DbcCatalogue, AParameterGroupIsFoundFromAnySenderAndPriority) {
  const std::string text = group(0x0CF029FE, "slope");
  EXPECT_TRUE(found(text, "0CF02980#00"));
  EXPECT_TRUE(found(text, "18F029E2#00"));
  EXPECT_FALSE(found(text, "0CF02A80#00"));
  EXPECT_FALSE(found(text, "0DF02980#00"));  // another data page
  EXPECT_FALSE(found(text, "029#00"));
  EXPECT_FALSE(found(text, "0CF02980#R"));
}

TEST(DbcCatalogue, ASenderInTheFileIsTheOnlyOne) {
  const std::string text = group(0x0CF029E2, "mine");
  EXPECT_TRUE(found(text, "18F029E2#00"));
  EXPECT_FALSE(found(text, "18F02980#00"));
  EXPECT_EQ(found(text + group(0x0CF029FE, "any"), "18F02980#00"), 1u);
  EXPECT_EQ(found(text + group(0x0CF029FE, "any"), "18F029E2#00"), 0u);
}

TEST(DbcCatalogue, TheDestinationOfAnAddressedGroupIsNotCompared) {
  EXPECT_TRUE(found(group(0x18EA00FE, "request"), "18EAFF42#00EE00"));
}

TEST(DbcCatalogue, WithoutJ1939TheWholeIdentifierCounts) {
  const Catalogue catalogue(test::sound(group(0x0CF029FE, "slope")));
  EXPECT_TRUE(catalogue.find(wire::test::frame("0CF029FE#00")));
  EXPECT_FALSE(catalogue.find(wire::test::frame("0CF02980#00")));
}

}  // namespace dbc_plan_test
}  // namespace drydock::wire::dbc

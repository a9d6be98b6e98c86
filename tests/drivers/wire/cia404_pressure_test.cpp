#include "drivers/wire/canopen/cia404_pressure.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::cia404_pressure {
namespace cia404_pressure_test {

using test::frame;
using test::text_of;

ProcessValue value_of(const std::string& text) {
  return test::only<ProcessValue, Cia404Pressure>({frame(text)});
}

Scale scale(Form form, const char* unit, unsigned decimals) {
  return {form, *find_unit(unit), decimals};
}

// Danfoss DST P92C, IC.PS.P21.1B.02 section 3.5: A0 86 01 00 00 means 100000, valid.
TEST(Cia404Pressure, ReadsTheExampleOfDanfoss) {
  const auto value = value_of("181#A086010000");
  EXPECT_EQ(as_integer(value), 100000);
  EXPECT_EQ(value.status, 0);
  EXPECT_DOUBLE_EQ(*pressure_pa(value, scale(Form::integer_and_status, "Pa", 0)), 100000);
  EXPECT_DOUBLE_EQ(*pressure_pa(value, scale(Form::integer_and_status, "bar", 5)), 100000);
  EXPECT_DOUBLE_EQ(*pressure_pa(value, scale(Form::integer_and_status, "kPa", 3)), 100000);
  EXPECT_EQ(text_of(encode(1, 100000, scale(Form::integer_and_status, "Pa", 0))), "181#A086010000");
}

TEST(Cia404Pressure, ReadsTheVectorsOfTheMakers) {
  const auto lines = test::lines_of(test::corpus("can_depth/canopen_pressure_vectors.tsv"));
  if (lines.empty()) GTEST_SKIP() << "corpora absent: can_depth";
  unsigned checked = 0;
  for (const auto& line : lines) {
    const auto payload_at = line.find('\t') + 1;
    const auto payload = line.substr(payload_at, line.find('\t', payload_at) - payload_at);
    const auto stated = line.find("i32 = ");  // a line with bytes and their value
    if (stated == std::string::npos) continue;
    const auto value = value_of("181#" + payload);
    EXPECT_EQ(as_integer(value), std::stol(line.substr(stated + 6))) << line;
    EXPECT_EQ(value.status, 0) << line;
    ++checked;
  }
  EXPECT_GT(checked, 0U);
}

TEST(Cia404Pressure, AStatusThatIsNotZeroLeavesNoPressure) {
  const auto in_pascals = scale(Form::integer_and_status, "Pa", 0);
  for (const char* text : {"181#A086010001", "181#A086010002", "181#A086010004"}) {
    EXPECT_FALSE(pressure_pa(value_of(text), in_pascals)) << text;
  }
}

TEST(Cia404Pressure, RealNumbersStandAloneOrBeforeAnotherObject) {
  const auto in_bar = scale(Form::real32, "bar", 0);
  EXPECT_DOUBLE_EQ(*pressure_pa(value_of("181#00002441"), in_bar), 10.25e5);
  EXPECT_DOUBLE_EQ(*pressure_pa(value_of("181#0000A44100000000"), in_bar), 20.5e5);  // DPS5000
  EXPECT_FALSE(pressure_pa(value_of("181#0000C07F"), in_bar));                       // not a number
  EXPECT_FALSE(pressure_pa(value_of("181#0000807F"), in_bar));                       // infinite
  EXPECT_EQ(text_of(encode(1, 10.25e5, in_bar)), "181#00002441");
}

// CiA 303-2: prefix, unit. bar and Pa are also in the makers' dictionaries.
TEST(Cia404Pressure, UnitsAreTheirCodesAndSizes) {
  EXPECT_EQ(find_unit("bar")->code, 0x004E0000U);
  EXPECT_EQ(find_unit("Pa")->code, 0x00220000U);
  EXPECT_EQ(find_unit("mbar")->code, 0xFD4E0000U);
  EXPECT_EQ(find_unit("furlong"), nullptr);
  EXPECT_DOUBLE_EQ(find_unit("mbar")->pascals, 100);
  EXPECT_NEAR(find_unit("psi")->pascals, 0.45359237 * 9.80665 / (0.0254 * 0.0254), 1e-8);
}

TEST(Cia404Pressure, WhatDoesNotFitIsAnOverloadAndWhatIsMissingIsNotValid) {
  const auto fine = scale(Form::integer_and_status, "Pa", 3);
  EXPECT_EQ(text_of(encode(1, 3e6, fine)), "181#FFFFFF7F03");
  EXPECT_EQ(text_of(encode(1, -3e6, fine)), "181#0000008005");
  EXPECT_EQ(text_of(encode(1, std::nullopt, fine)), "181#0000000001");
}

RC_GTEST_PROP(Cia404Pressure, ComesBackToHalfAStep, ()) {
  const double pressure = *rc::gen::inRange(-100'000, 100'000'000);
  const auto decimals = *rc::gen::inRange(0u, 4u);
  const auto in_kpa = scale(Form::integer_and_status, "kPa", decimals);
  const auto value = test::only<ProcessValue, Cia404Pressure>({encode(1, pressure, in_kpa)});
  const auto back = pressure_pa(value, in_kpa);
  RC_ASSERT(std::abs(*back - pressure) <= 500.0001 / std::pow(10.0, decimals));
}

TEST(Cia404Pressure, OtherLengthsAreDamaged) {
  Cia404Pressure::Decoder decoder;
  EXPECT_FALSE(decoder.receive(frame("181#A08601")));
  EXPECT_FALSE(decoder.receive(frame("181#A08601000000")));
  EXPECT_EQ(decoder.counters().bad_checksums, 2U);
}

}  // namespace cia404_pressure_test
}  // namespace drydock::wire::cia404_pressure

#include <gtest/gtest.h>

#include <limits>

#include "tests/drivers/wire/dbc_files.hpp"

/// DBC files as other programs write them: what is legal but seldom, and mistakes that change no
/// value. The forms come from cantools' test files, commaai/opendbc, and issues of parsers.
namespace drydock::wire::dbc {
namespace dbc_lenience_test {

using test::all;

const std::string one = "BO_ 1 a: 8 n\n SG_ s : 0|64@1+ (1,0) [0|0] \"\" n\n";
const std::string two = "BO_ 2 b: 8 n\n SG_ t : 0|8@1+ (1,0) [0|0] \"\" n\n";

std::string warnings_of(const std::string& text) {
  const Reading reading = read(text);
  EXPECT_EQ(all(reading.errors), "");
  return all(reading.warnings);
}

std::size_t messages_of(const std::string& text) { return read(text).database.messages.size(); }

// CANdb++ writes 15 digits, so its largest double is more than the largest double.
TEST(DbcLenience, ARangeOfAllDoublesHasTheNearestDoubles) {
  const auto database = test::sound(
      "BO_ 1 a: 8 n\n SG_ s : 0|64@1- (1,0) [-1.79769313486232E+308|1.79769313486232E+308] \"\" n\n"
      "SIG_VALTYPE_ 1 s : 2;\n");
  const Signal& s = database.messages[0].signals[0];
  EXPECT_EQ(s.lowest, -std::numeric_limits<double>::max());
  EXPECT_EQ(s.highest, std::numeric_limits<double>::max());
  EXPECT_EQ(s.layout.number, Number::float64);
}

TEST(DbcLenience, ARangeMayBeginAtTheSmallestNumberAndHaveNoEnd) {
  const auto database = test::sound(
      "BO_ 1 a: 8 n\n SG_ s : 0|8@1+ (1,0) [4.94E-330|inf] \"\" n\n"
      " SG_ t : 8|8@1+ (1,0) [nan|NaN] \"\" n\n");
  EXPECT_EQ(database.messages[0].signals[0].lowest, 0);
  EXPECT_EQ(database.messages[0].signals[0].highest, std::numeric_limits<double>::max());
  EXPECT_EQ(database.messages[0].signals[1].lowest, 0);
  EXPECT_EQ(database.messages[0].signals[1].highest, 0);
}

TEST(DbcLenience, AFactorBeyondAllDoublesIsAnError) {
  EXPECT_EQ(all(read("BO_ 1 a: 8 n\n SG_ s : 0|8@1+ (1E+400,0) [0|0] \"\" n\n").errors),
            "2:18: the factor is no number\n");
}

TEST(DbcLenience, AValueWithANameMayHaveAll64BitsOrAFraction) {
  const auto reading = read(
      one + "VAL_ 1 s 18446744073709551615 \"none\" 3.0 \"three\" 1E+3 \"k\" 0.5 \"half\" ;\n");
  EXPECT_EQ(all(reading.errors), "");
  EXPECT_EQ(all(reading.warnings),
            "3:59: no raw value is this number, so the name is never told\n");
  const Signal& s = reading.database.messages[0].signals[0];
  ASSERT_TRUE(s.label_of(-1));  // all 64 bits
  EXPECT_EQ(*s.label_of(-1), "none");
  EXPECT_EQ(*s.label_of(3), "three");
  EXPECT_EQ(*s.label_of(1000), "k");
  EXPECT_EQ(s.labels.size(), 3u);
}

TEST(DbcLenience, SelectingValuesMayStandAloneInTheirList) {
  const auto database = test::sound(
      "BO_ 1 a: 8 n\n SG_ m M : 0|8@1+ (1,0) [0|0] \"\" n\n"
      " SG_ s m1 : 8|8@1+ (1,0) [0|0] \"\" n\nSG_MUL_VAL_ 1 s m 1, 4-5;\n");
  EXPECT_EQ(database.messages[0].signals[1].when, (std::vector<Range>{{1, 1}, {4, 5}}));
}

TEST(DbcLenience, KeywordsUnderNsNeedNotBeIndented) {
  EXPECT_EQ(messages_of("NS_ :\nNS_DESC_\nCM_\nVAL_\nSG_MUL_VAL_\n\nBS_:\nBU_: n\n" + one + two +
                        "CM_ \"x\";\n"),
            2u);
}

TEST(DbcLenience, AMissingSemicolonIsAWarningAndSwallowsNothing) {
  EXPECT_EQ(warnings_of("VAL_TABLE_ x 0 \"no\" 1 \"yes\"\n" + one + "SIG_GROUP_ 1 g 1 : s\n" + two),
            "2:1: ';' is missing\n5:1: ';' is missing\n");
  EXPECT_EQ(messages_of("VAL_TABLE_ x 0 \"no\" 1 \"yes\"\n" + one + "SIG_GROUP_ 1 g 1 : s\n" + two),
            2u);
  EXPECT_EQ(warnings_of("CM_ \"made by a program\"\n" + one), "2:1: ';' is missing\n");
  const std::string labels = one + two + "VAL_ 1 s 2 \"two\" 1 \"one\"\nVAL_ 2 t 3 \"three\" ;\n";
  EXPECT_EQ(warnings_of(labels), "6:1: ';' is missing\n");
  EXPECT_EQ(*read(labels).database.messages[0].signals[0].label_of(2), "two");
  EXPECT_EQ(*read(labels).database.messages[1].signals[0].label_of(3), "three");
  EXPECT_EQ(warnings_of(one + "BA_DEF_ BO_ \"x\" INT 0 5\nBA_DEF_DEF_ \"x\" 0\nBA_ \"x\" BO_ 1 3"),
            "4:1: ';' is missing\n5:1: ';' is missing\n5:16: ';' is missing\n");
}

// Else a float would be read as an integer, with no more than a warning.
TEST(DbcLenience, WhatIsSaidOfAMessageMayStandInFrontOfIt) {
  const auto database = test::sound(
      "SIG_VALTYPE_ 1 f : 1;\nVAL_ 1 g 3 \"three\" ;\nBA_ \"GenMsgCycleTime\" BO_ 1 20;\n"
      "BO_ 1 a: 8 n\n SG_ f : 0|32@1- (1,0) [0|0] \"\" n\n SG_ g : 32|8@1+ (1,0) [0|0] \"\" n\n");
  ASSERT_EQ(database.messages.size(), 1u);
  EXPECT_EQ(database.messages[0].signals[0].layout.number, Number::float32);
  ASSERT_TRUE(database.messages[0].signals[1].label_of(3));
  EXPECT_EQ(database.messages[0].cycle_ms, 20u);
  EXPECT_EQ(warnings_of("CM_ BO_ 7 \"no message\";\n" + one + "VAL_ 1 x 0 \"no\" ;\n"),
            "1:9: no message has this identifier\n4:8: message a has no signal x\n");
}

TEST(DbcLenience, ACommentOnASignalMayNameNone) {
  EXPECT_EQ(warnings_of(one + "CM_ SG_ 1 \"of no signal; BO_ \";\n" + two),
            "3:11: the comment names no signal\n");
}

// C:\logs\ at the end of a text: the last backslash is no escape, or all that follows is lost.
TEST(DbcLenience, ATextMayEndWithABackslash) {
  const auto database = test::sound(one + "CM_ SG_ 1 s \"see C:\\logs\\\";\n" + two +
                                    "CM_ SG_ 2 t \"say \\\"a\\\";\n and go on\";\n");
  EXPECT_EQ(database.messages[0].signals[0].comment, "see C:\\logs\\");
  ASSERT_EQ(database.messages.size(), 2u);
  EXPECT_EQ(database.messages[1].signals[0].comment, "say \"a\";\n and go on");
}

TEST(DbcLenience, TheEndOfFileMarkOfDosEndsNothing) {
  EXPECT_EQ(test::sound(one + "\x1A").messages.size(), 1u);
  EXPECT_EQ(test::sound(one + std::string(3, '\0')).messages.size(), 1u);
}

TEST(DbcLenience, AFileOfUtf16SaysWhatItIs) {
  EXPECT_EQ(all(read("\xFF\xFE" + std::string("V\0E\0", 4)).errors),
            "1:1: the file is UTF-16: convert it to UTF-8\n");
}

}  // namespace dbc_lenience_test
}  // namespace drydock::wire::dbc

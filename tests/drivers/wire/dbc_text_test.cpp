#include <gtest/gtest.h>

#include "tests/drivers/wire/dbc_files.hpp"

/// What the reader says of DBC texts, of sound ones and of damaged ones.
namespace drydock::wire::dbc {
namespace dbc_text_test {

using test::all;

std::string errors_of(const std::string& text) { return all(read(text).errors); }
std::string warnings_of(const std::string& text) { return all(read(text).warnings); }

const std::string imu =
    "VERSION \"\"\n\nNS_ :\n\tBA_\n\tSG_MUL_VAL_\n\nBS_:\n\nBU_: imu\n\n"
    "BO_ 50 rate: 6 imu\n"
    " SG_ x : 7|16@0- (0.001953125,0) [-64|63.998] \"rad/s\" Vector__XXX\n";

TEST(DbcText, KeywordsUnderNsAreNoStatements) {
  const auto database = test::sound(imu);
  ASSERT_EQ(database.messages.size(), 1u);
  EXPECT_EQ(database.messages[0].senders, std::vector<std::string>{"imu"});
  EXPECT_EQ(database.messages[0].signals[0].layout.factor, 1.0 / 512);
}

TEST(DbcText, LineEndsOfBothKindsReadTheSame) {
  std::string crlf;
  for (const char c : imu) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(test::sound(crlf).messages[0].signals[0].name, "x");
}

TEST(DbcText, WhatCanHaveNoValueIsAWarning) {
  EXPECT_EQ(warnings_of("BO_ 1 a: 8 n\n SG_ s : 0|8@1+ (0,5) [0|0] \"\" n\n"),
            "2:6: signal s has the factor 0: it always is its offset\n");
  EXPECT_EQ(warnings_of("BO_ 1 a: 8 n\n SG_ s M : 0|8@1+ (1,0) [0|0] \"\" n\n"
                        " SG_ t m0 : 8|8@1+ (1,0) [0|0] \"\" n\nSG_MUL_VAL_ 1 t s 1-2, 5-1;\n"),
            "4:24: the range ends before it begins, so no value is in it\n");
}

TEST(DbcText, AnErrorNamesLineAndColumn) {
  EXPECT_EQ(errors_of("BO_ 1 a: 8 n\n SG_ s : 0|8@2+ (1,0) [0|0] \"\" n\n"),
            "2:14: one of \"01\" is missing\n");
  EXPECT_EQ(errors_of("BO_ 1 a: 8 n\n SG_ s : 0|65@1+ (1,0) [0|0] \"\" n\n"),
            "2:12: the number of bits is beyond 1 to 64\n");
  EXPECT_EQ(errors_of("BO_ 1 a: 8 n\n SG_ s : 0|8@1+ (x,0) [0|0] \"\" n\n"),
            "2:18: the factor is no number\n");
  EXPECT_EQ(errors_of("BO_ 1 : 8 n\n"), "1:7: the message's name is missing\n");
  EXPECT_EQ(errors_of("\n\n  WHAT_ 1;\n"), "3:3: no statement begins so\n");
  EXPECT_EQ(errors_of("CM_ \"never ends;\n"), "1:5: the text in quotes has no end\n");
  EXPECT_EQ(errors_of("BO_ 3758096384 a: 8 n\n"), "1:5: the identifier has more than 29 bits\n");
}

TEST(DbcText, ColumnsCountCharactersNotBytes) {
  EXPECT_EQ(errors_of("CM_ \"\xC2\xB0\" x;\n"), "1:9: ';' is missing\n");
}

TEST(DbcText, ReadingGoesOnBehindAnError) {
  const auto reading = read(
      "BO_ 1 a: 8 n\n SG_ bad : 0|8@1 (1,0) [0|0] \"\" n\n"
      " SG_ good : 8|8@1+ (1,0) [0|0] \"\" n\nBO_ 2 b: 8 n\n");
  EXPECT_EQ(reading.errors.size(), 1u);
  ASSERT_EQ(reading.database.messages.size(), 2u);
  ASSERT_EQ(reading.database.messages[0].signals.size(), 1u);
  EXPECT_EQ(reading.database.messages[0].signals[0].name, "good");
}

TEST(DbcText, RemarksAreBoundedAndTheRestIsCounted) {
  std::string text;
  for (int i = 0; i < 150; ++i) text += "WHAT_ 1;\nVERSION \"\"\n";
  const auto reading = read(text);
  EXPECT_EQ(reading.errors.size(), most_remarks);
  EXPECT_EQ(reading.remarks_left_out, 50u);
}

TEST(DbcText, NumbersMayHaveAPlusAndAnExponent) {
  const auto database = test::sound(
      "BO_ 1 a: 8 n\n SG_ s : 0|8@1+ (1E-007,+3.05185094759972E-005) [-1|+127] \"\" n\n");
  const Signal& s = database.messages[0].signals[0];
  EXPECT_EQ(s.layout.factor, 1e-7);
  EXPECT_EQ(s.layout.offset, 3.05185094759972e-5);
  EXPECT_EQ(s.highest, 127);
}

TEST(DbcText, CommentsRunOverLinesAndKeepTheirQuotes) {
  const auto database =
      test::sound(imu + "CM_ SG_ 50 x \"one; \\\"two\\\"\nBO_ three\" ; // end\n");
  EXPECT_EQ(database.messages[0].signals[0].comment, "one; \"two\"\nBO_ three");
  EXPECT_EQ(database.messages.size(), 1u);
}

TEST(DbcText, WindowsLettersBecomeUtf8) {
  const auto database = test::sound("BO_ 1 a: 8 n\n SG_ s : 0|8@1+ (1,0) [0|0] \"\xB0 \x80\" n\n");
  EXPECT_EQ(database.messages[0].signals[0].unit, "\xC2\xB0 \xE2\x82\xAC");  // degree, euro
  const auto utf8 = test::sound("BO_ 1 a: 8 n\n SG_ s : 0|8@1+ (1,0) [0|0] \"\xC2\xB0\" n\n");
  EXPECT_EQ(utf8.messages[0].signals[0].unit, "\xC2\xB0");
}

TEST(DbcText, AnIdentifierAbove7FFWithoutBit31IsOf29BitsWithAWarning) {
  const auto reading = read("BO_ 506855454 a: 8 n\n");
  EXPECT_TRUE(reading.database.messages[0].extended);
  EXPECT_EQ(all(reading.warnings),
            "1:5: an identifier above 7FFh without bit 31: taken for one of 29 bits\n");
}

TEST(DbcText, TheSameNumberWithAndWithoutBit31IsTwoMessages) {
  const auto database = test::sound("BO_ 3 a: 8 n\nBO_ 2147483651 b: 8 n\n");
  EXPECT_FALSE(database.messages[0].extended);
  EXPECT_TRUE(database.messages[1].extended);
  EXPECT_EQ(database.messages[1].id, 3u);
}

TEST(DbcText, OrphanSignalsAreNoMessage) {
  const auto database = test::sound(
      "BO_ 3221225472 VECTOR__INDEPENDENT_SIG_MSG: 0 Vector__XXX\n"
      " SG_ s : 0|8@1+ (1,0) [0|0] \"\" n\nCM_ SG_ 3221225472 s \"none\";\n");
  EXPECT_TRUE(database.messages.empty());
}

TEST(DbcText, ADefaultHoldsForEveryMessageWithoutItsOwn) {
  const auto database = test::sound(
      "BO_ 2147483904 a: 8 n\nBO_ 2147484160 b: 8 n\nBO_ 7 c: 8 n\n"
      "BA_DEF_ BO_ \"VFrameFormat\" ENUM "
      "\"StandardCAN\",\"ExtendedCAN\",\"reserved\",\"J1939PG\";\n"
      "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 65535;\n"
      "BA_DEF_DEF_ \"VFrameFormat\" \"J1939PG\";\nBA_DEF_DEF_ \"GenMsgCycleTime\" 100;\n"
      "BA_ \"VFrameFormat\" BO_ 2147484160 1;\nBA_ \"GenMsgCycleTime\" BO_ 2147484160 20;\n");
  EXPECT_EQ(database.messages[0].format, FrameFormat::j1939);
  EXPECT_EQ(database.messages[1].format, FrameFormat::classic);
  EXPECT_EQ(database.messages[2].format, FrameFormat::classic);  // 11 bits
  EXPECT_EQ(database.messages[0].cycle_ms, 100u);
  EXPECT_EQ(database.messages[1].cycle_ms, 20u);
}

TEST(DbcText, SignalsThatShareBitsOrEndBeyondTheMessageAreReportedAndKept) {
  const std::string text =
      "BO_ 1 a: 2 n\n SG_ s : 0|9@1+ (1,0) [0|0] \"\" n\n SG_ t : 15|8@0+ (1,0) [0|0] \"\" n\n"
      " SG_ u : 14|4@1+ (1,0) [0|0] \"\" n\n";
  EXPECT_EQ(errors_of(text), "");
  EXPECT_EQ(warnings_of(text),
            "3:6: signal t shares bits with s\n"
            "4:6: signal u ends beyond the 2 bytes of a\n"
            "4:6: signal u shares bits with t\n");
}

TEST(DbcText, SignalsOfDifferentSelectingValuesMayShareBits) {
  EXPECT_EQ(warnings_of("BO_ 1 a: 2 n\n SG_ s M : 0|8@1+ (1,0) [0|0] \"\" n\n"
                        " SG_ t m0 : 8|8@1+ (1,0) [0|0] \"\" n\n"
                        " SG_ u m1 : 8|8@1+ (1,0) [0|0] \"\" n\n"),
            "");
}

TEST(DbcText, AMultiplexedSignalNeedsItsSelector) {
  const std::string line = " (1,0) [0|0] \"\" n\n";
  EXPECT_EQ(errors_of("BO_ 1 a: 8 n\n SG_ s m0 : 0|8@1+" + line),
            "2:6: multiplexed signal s: its message has no selector\n");
  EXPECT_EQ(errors_of("BO_ 1 a: 8 n\n SG_ s m0 : 0|8@1+" + line + " SG_ a M : 8|8@1+" + line +
                      " SG_ b M : 16|8@1+" + line),
            "2:6: multiplexed signal s: SG_MUL_VAL_ has to say which selector chooses it\n");
  EXPECT_EQ(
      errors_of("BO_ 1 a: 8 n\n SG_ s m0M : 0|8@1+" + line + " SG_ t m0M : 8|8@1+" + line +
                "SG_MUL_VAL_ 1 s t 0-0;\nSG_MUL_VAL_ 1 t s 0-0;\n"),
      "2:6: multiplexed signal s: its selectors select each other, or more than 8 stand above "
      "it\n");
  EXPECT_EQ(errors_of("BO_ 1 a: 8 n\n SG_ s x0 : 0|8@1+" + line),
            "2:8: neither ':' nor a multiplexor as M, m0, m0M\n");
}

TEST(DbcText, AFloatHasTheBitsOfItsType) {
  EXPECT_EQ(errors_of("BO_ 1 a: 8 n\n SG_ s : 0|16@1- (1,0) [0|0] \"\" n\nSIG_VALTYPE_ 1 s : 1;\n"),
            "3:20: a floating-point number has 32 bits (1) or 64 bits (2)\n");
}

TEST(DbcText, AReferenceToNothingIsAWarning) {
  EXPECT_EQ(warnings_of("BO_ 1 a: 8 n\nCM_ BO_ 2 \"text\";\nVAL_ 1 s 0 \"no\" ;\n"),
            "2:9: no message has this identifier\n3:8: message a has no signal s\n");
}

}  // namespace dbc_text_test
}  // namespace drydock::wire::dbc

#include <gmock/gmock.h>

#include "tests/drivers/decode/captured.hpp"

namespace drydock::decode {
namespace decode_by_pgns_test {

using nlohmann::json;
using testing::HasSubstr;

const std::string folder = DRYDOCK_SOURCE_DIR "/fixtures/pgns/";

Decoded by_pgns(const std::string& table, const std::string& capture, bool count = false) {
  DecodeOptions options;
  options.pgns = table;
  options.file = capture;
  options.count = count;
  return run_decode(options);
}

json fields_of(const std::string& type, std::size_t index = 0) {
  for (const json& line : by_pgns(folder + "table.json", folder + "frames.log").lines())
    if (line.at("type") == type && index-- == 0) return line.at("fields");
  return nullptr;
}

TEST(DecodeByPgns, ALineSaysWhoSentWhatAndWhen) {
  const auto lines = by_pgns(folder + "table.json", folder + "frames.log").lines();
  json first = lines.at(0);
  first.erase("fields");
  EXPECT_EQ(first, (json{{"type", "vesselHeading"},
                         {"time_s", 0.1},
                         {"interface", "can0"},
                         {"pgn", 127250},
                         {"source", 53},
                         {"destination", 255}}));
}

TEST(DecodeByPgns, NumbersHaveTheirScaleAndWhatIsNotAvailableIsNull) {
  EXPECT_EQ(fields_of("vesselHeading"), (json{{"sid", 1},
                                              {"heading", 1.0},
                                              {"deviation", nullptr},
                                              {"variation", 0.04},
                                              {"reference", 1},
                                              {"reference_label", "Magnetic"}}));
  EXPECT_EQ(fields_of("power"), (json{{"power", 1500.0}, {"scale", 0.5}}));
}

/// Messages of canboat's pgn-below-range-min.in, which it reads as `"Roll":-3.1416` alone and as
/// `"Current":-3276.8`. An angle ends at pi; the range of the current only leaves its lowest number
/// out.
TEST(DecodeByPgns, AnAngleBelowItsRangeIsNoValue) {
  const std::string angle =
      R"("FieldType": "NUMBER", "BitLength": 16, "Resolution": 0.0001, "Signed": true, )"
      R"("RangeMin": -3.1415926, "RangeMax": 3.1415926})";
  const TemporaryFile table(
      R"({"PGNs": [{"PGN": 127257, "Id": "attitude", "Type": "Single", "Fields": [)"
      R"({"Id": "sid", "FieldType": "NUMBER", "BitLength": 8}, {"Id": "yaw", )" +
      angle + R"(, {"Id": "pitch", )" + angle + R"(, {"Id": "roll", )" + angle +
      R"(]}, {"PGN": 127508, "Id": "battery", "Type": "Single", "Fields": [)"
      R"({"Id": "instance", "FieldType": "NUMBER", "BitLength": 8},)"
      R"({"Id": "voltage", "FieldType": "NUMBER", "BitLength": 16, "Resolution": 0.01, "Signed": true},)"
      R"({"Id": "current", "FieldType": "NUMBER", "BitLength": 16, "Resolution": 0.1, "Signed": true,)"
      R"( "RangeMin": -3276.7, "RangeMax": 3276.4}]}]})");
  const TemporaryFile log(
      "(1.0) can0 0DF11902#01008047854885FF\n(1.1) can0 19F21403#00E2040080FFFFFF\n");
  const auto lines = by_pgns(table.path(), log.path()).lines();
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].at("fields"),
            (json{{"sid", 1}, {"yaw", nullptr}, {"pitch", nullptr}, {"roll", -3.1416}}));
  EXPECT_EQ(lines[1].at("fields").at("current"), -3276.8);
}

/// canboat reads 2013.03.01 and 19:28:16.0000.
TEST(DecodeByPgns, DatesAreDaysAndTimesSecondsOfTheDay) {
  EXPECT_EQ(fields_of("systemTime"), (json{{"sid", 1},
                                           {"source", 0},
                                           {"source_label", "GPS"},
                                           {"date", "2013-03-01"},
                                           {"time", 19 * 3600 + 28 * 60 + 16.0}}));
}

TEST(DecodeByPgns, FieldsComeAsOftenAsTheMessageSays) {
  const json fields = fields_of("samples");
  EXPECT_EQ(fields.at("manufacturerCode_label"), "Nobody");
  EXPECT_EQ(fields.at("list"),
            json::parse(R"([{"index":1,"level":-1.0},{"index":2,"level":null}])"));
}

TEST(DecodeByPgns, TextsAreUtf8WhateverTheyWere) {
  EXPECT_EQ(fields_of("configuration"),
            (json{{"first", "abc"}, {"second", "A\u3042"}, {"third", nullptr}}));
  EXPECT_EQ(fields_of("texts"), (json{{"name", "AB"}, {"digits", "1234"}, {"rest", "BEEF"}}));
}

TEST(DecodeByPgns, EachSetBitHasItsMeaning) {
  EXPECT_EQ(fields_of("warnings"),
            (json{{"status", 5}, {"status_bits", json::array({"Hot", "Low Oil"})}}));
}

TEST(DecodeByPgns, ALookupMayDependOnAnotherField) {
  EXPECT_EQ(fields_of("node"), (json{{"function", 130},
                                     {"function_label", "Bottom Depth"},
                                     {"class", 60},
                                     {"class_label", "Navigation"},
                                     {"ship", "002290000"}}));
}

TEST(DecodeByPgns, AKeySaysHowItsValueIsRead) {
  EXPECT_EQ(fields_of("setting"),
            (json{{"key", 0}, {"key_label", "Heading Offset"}, {"value", 1.0}}));
  EXPECT_EQ(fields_of("setting", 1), (json{{"key", 7}, {"key_label", nullptr}, {"value", "ABCD"}}));
}

TEST(DecodeByPgns, AParameterIsReadAsTheFieldOfItsPgn) {
  const json fields = fields_of("command");
  EXPECT_EQ(fields.at("pgn"), 127250);
  EXPECT_EQ(fields.at("list"), json::parse(R"([
      {"parameter":2,"parameter_label":"heading","value":1.0},
      {"parameter":5,"parameter_label":"reference","value":1,"value_label":"Magnetic"}])"));
}

TEST(DecodeByPgns, AMessageThatEndsEarlyHasNoValuesBehindItsEnd) {
  const json fields = fields_of("vesselHeading", 1);
  EXPECT_EQ(fields.at("heading"), 1.0);
  EXPECT_EQ(fields.at("variation"), nullptr);
}

TEST(DecodeByPgns, WhatTheTableDoesNotHaveIsCountedByName) {
  EXPECT_EQ(by_pgns(folder + "table.json", folder + "frames.log").err,
            "candump-log: 19 frames, 12 messages, 1 of them cut short, 0 incomplete\n"
            "passed over:\n"
            "       1  PGN 130306 wind\n"
            "       1  PGN 130816 of a form that the table does not have\n"
            "       1  PGN 61184 proprietary\n"
            "       1  identifier 123\n");
}

TEST(DecodeByPgns, CountsMessagesByTheirName) {
  const auto lines = by_pgns(folder + "table.json", folder + "frames.log", true).lines();
  ASSERT_EQ(lines.size(), 10u);
  EXPECT_EQ(lines.back(), (json{{"type", "warnings"}, {"count", 1}}));
}

std::string changed(std::string_view from, std::string_view to) {
  std::string text = read_file(folder + "table.json");
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

/// A subset of canboat's file has not all of its lookups.
TEST(DecodeByPgns, AFieldOfALookupThatTheTableDoesNotHaveIsANumberAndTheLookupIsNamed) {
  const TemporaryFile table(
      changed("\"LookupEnumeration\": \"MAKER\"", "\"LookupEnumeration\": \"NONE\""));
  const Decoded with = by_pgns(folder + "table.json", folder + "frames.log");
  const Decoded without = by_pgns(table.path(), folder + "frames.log");
  EXPECT_EQ(without.exit_code, 0) << without.err;
  EXPECT_THAT(without.err,
              HasSubstr("numbers without a label, as the table does not have their lookups: NONE"));
  ASSERT_EQ(without.lines().size(), with.lines().size());
  EXPECT_NE(without.out, with.out) << "one label is gone";
}

void refused(std::string_view text, std::string_view why) {
  const TemporaryFile file(text);
  const Decoded decoded = by_pgns(file.path(), folder + "frames.log");
  EXPECT_EQ(decoded.exit_code, 2) << why;
  EXPECT_EQ(decoded.out, "");
  EXPECT_THAT(decoded.err, HasSubstr(std::string(why)));
}

TEST(DecodeByPgns, ABadTableIsRefusedWithThePlace) {
  refused("{ \"PGNs\": [", "line 1, column 12");
  refused("[]", "the file: expected an object");
  refused("{}", "the file: \"PGNs\" is missing");
  refused(R"({"PGNs": []})", "PGNs: no definitions");
  refused(changed("\"FieldType\": \"PGN\"", "\"FieldType\": \"COLOUR\""),
          "PGNs[1].Fields[1].FieldType: unknown FieldType \"COLOUR\", allowed: NUMBER, ");
  refused(changed("\"BitLength\": 8,", "\"BitLength\": 0,"),
          "PGNs[1].Fields[0].BitLength: expected a whole number from 1 to");
  refused(changed("\"BitOffset\": 32", "\"BitOffset\": 33"),
          "PGNs[1]: priority has BitOffset 33, but the fields before it have 32 bits");
  refused(changed("\"Id\": \"priority\"", "\"Id\": \"a \\\"b\""),
          "PGNs[1].Fields[2].Id: expected letters, digits and _");
  refused(changed("\"RepeatingFieldSet1CountField\": 5", "\"RepeatingFieldSet1CountField\": 6"),
          "PGNs[1].RepeatingFieldSet1CountField: expected a whole number from 1 to 5");
  refused(changed("\"LookupIndirectEnumerationFieldOrder\": 3",
                  "\"LookupIndirectEnumerationFieldOrder\": 9"),
          "PGNs[9]: function depends on field 9, the last is 4");
  refused(changed("\"Resolution\": 0.01", "\"Resolution\": 0"), "expected more than 0");
}

TEST(DecodeByPgns, ATableThatIsTooLongIsNotReadToItsEnd) {
  refused(std::string(17 * 1024 * 1024, ' '), "the file has more than 16777216 bytes");
}

TEST(DecodeByPgns, AMissingTableIsSaid) {
  const Decoded decoded = by_pgns("/no/such.json", folder + "frames.log");
  EXPECT_EQ(decoded.exit_code, 2);
  EXPECT_THAT(decoded.err, HasSubstr("cannot read /no/such.json: No such file"));
}

}  // namespace decode_by_pgns_test
}  // namespace drydock::decode

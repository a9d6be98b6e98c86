#include <gmock/gmock.h>

#include "drivers/wire/described/line_pattern.hpp"
#include "tests/drivers/described/decoded.hpp"
#include "tests/drivers/device/allocation_count.hpp"
#include "tests/drivers/property.hpp"

/// Lines by a regular expression. The lines and their values are written by hand.
namespace drydock::described::test {
namespace pattern_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using namespace wire::testing;
using wire::described::Decoded;
using wire::described::LinePattern;
using wire::described::Record;

constexpr std::string_view sounder = R"(
[sensor]
title = "toy sounder"
kind = "depth"
[protocol]
[[protocol.lines]]
name = "ping"
head = "Ping "
pattern = '#(?P<count>[0-9]+): (?P<depth>-?[0-9]+\.[0-9]+) ?(?:(?P<metres>m)|ft)(?:@(?P<celsius>-?[0-9.]+)C)?(?:,(?P<state>ok|bad))?(?:/(?P<volt>[0-9.]+)V)?'
emulate = '#{count}: {depth} m@{celsius}C'
fields = [
  {group = "count", emulate = 7, decimals = 0},
  {group = "depth", field = "depth_m", unit = "m", decimals = 2},
  {group = "celsius", field = "temperature_k", unit = "degC", decimals = 1},
  {group = "metres", type = "text"},
  {group = "volt", name = "battery_v"},
]
)";

TEST(LinePatterns, ALineGivesTheValuesOfItsGroups) {
  const auto toy = described(sounder);
  const auto all = decoded(toy, "Ping #12: 3.25 m@-1.5C,ok/12.1V\r\n");
  EXPECT_DOUBLE_EQ(value_of(all, "count"), 12);
  EXPECT_DOUBLE_EQ(value_of(all, "depth_m"), 3.25);
  EXPECT_DOUBLE_EQ(value_of(all, "temperature_k"), 271.65);
  EXPECT_DOUBLE_EQ(value_of(all, "battery_v"), 12.1);
}

TEST(LinePatterns, AGroupThatTookNoPartHasNoValue) {
  const auto toy = described(sounder);
  const auto few = decoded(toy, "Ping #13: -0.10ft\n");
  EXPECT_DOUBLE_EQ(value_of(few, "depth_m"), -0.1);
  EXPECT_TRUE(std::isnan(value_of(few, "temperature_k")));
  EXPECT_TRUE(std::isnan(value_of(few, "battery_v")));
}

TEST(LinePatterns, ALineThatThePatternDoesNotFillIsSkippedAndCounted) {
  const auto toy = described(sounder);
  wire::Framer<1024> framer;
  int frames = 0;
  const auto feed = [&](std::string_view text) {
    framer.feed(as_bytes(text), wire::described::Scanner{&toy->plan},
                [&](wire::Bytes, std::size_t) { ++frames; });
  };
  feed("Ping #1: 2.0 m!\r\nPing #2: 2.0 m\r\nboot v1.2\r\nPing #3: 4.0 m\r\n");
  EXPECT_EQ(frames, 2);
  // The first line with its CR LF and "boot v1.2" CR LF.
  EXPECT_EQ(framer.counters().bytes_skipped, 17u + 11u);
}

TEST(LinePatterns, AnEmulatedDeviceWritesTheLineThatTheFileSays) {
  using enum wire::described::Target;
  const auto toy = described(sounder);
  wire::described::Readings readings;
  std::array<std::uint8_t, 256> bytes{};
  readings.set(depth, 12.344);
  readings.set(temperature, 277.15);
  const auto size = encode(toy->plan, toy->plan.messages[0], readings, bytes);
  EXPECT_EQ(as_text(wire::Bytes(bytes).first(size)), "Ping #7: 12.34 m@4.0C\r\n");
  EXPECT_TRUE(toy->plan.messages[0].emulated);
}

TEST(LinePatterns, TheDescriptionOfThePageReadsTheLinesOfThePage) {
  const auto page =
      rig_config::load_description(DRYDOCK_SOURCE_DIR "/fixtures/described/pattern.toml");
  ASSERT_TRUE(page);
  const auto first = decoded(*page, "Ping #12: 3.25 m@-1.5C\r\n");
  EXPECT_DOUBLE_EQ(value_of(first, "depth_m"), 3.25);
  EXPECT_DOUBLE_EQ(value_of(first, "temperature_k"), 271.65);
  EXPECT_DOUBLE_EQ(value_of(decoded(*page, "Ping #13: 4M\r\n"), "depth_m"), 4);
}

TEST(LinePatterns, WithoutALineToWriteNothingIsEmulated) {
  std::string text(sounder);
  const auto at = text.find("emulate = '");
  text.erase(at, text.find('\n', at) - at);
  EXPECT_FALSE(described(text)->plan.messages[0].emulated);
}

TEST(LinePatterns, NoLineOfAPatternThatAlwaysKnowsItsWayAllocates) {
  const auto toy = described(sounder);
  const Buffer line = as_bytes("Ping #12: 3.25 m@-1.5C,ok/12.1V\r\n");
  Record record;
  const auto read_one = [&] {
    return wire::described::scan(toy->plan, line) == wire::Scan::frame(line.size()) &&
           wire::described::decode(toy->plan, line, record) == Decoded::message;
  };
  ASSERT_TRUE(read_one());
  const device::test::AllocationCount allocations;
  int good = 0;
  for (int i = 0; i < 100; ++i) good += read_one();
  EXPECT_EQ(good, 100);
  EXPECT_EQ(allocations.so_far(), 0u) << "six groups: two passes";
}

TEST(LinePatterns, APatternThatMustTryTwoWaysAllocatesThreeTimesForFourGroups) {
  const LinePattern pattern(".*=(?P<a>[0-9]+),.*=(?P<b>[0-9]+)");
  std::array<std::string_view, wire::described::most_groups> found;
  ASSERT_TRUE(pattern.match("depth=12,height=34", found));
  const device::test::AllocationCount allocations;
  ASSERT_TRUE(pattern.match("depth=12,height=34", found));
  EXPECT_LE(allocations.so_far(), 3u);
  EXPECT_EQ(found[1], "34");
}

TEST(LinePatterns, TheTimeOfAMatchIsLinearInTheLine) {
  // The classic of engines that track back: 30 letters take them 2^30 steps.
  const LinePattern pattern("(?P<x>(?:a?){30}a{30})");
  ASSERT_EQ(pattern.error(), "");
  std::array<std::string_view, wire::described::most_groups> found;
  EXPECT_TRUE(pattern.match(std::string(30, 'a'), found));
  EXPECT_FALSE(pattern.match(std::string(29, 'a'), found));
}

TEST(LinePatterns, GroupsAreFoundBehindClassesAndEscapes) {
  const LinePattern pattern(R"([(?P<x>\]]\(\?P<(?P<a>[^]a]*)[[:alpha:](](?P<b>.))");
  EXPECT_EQ(pattern.error(), "");
  EXPECT_THAT(pattern.groups(), ElementsAre("a", "b"));
  std::array<std::string_view, wire::described::most_groups> found;
  ASSERT_TRUE(pattern.match("](?P<12z3", found));
  EXPECT_EQ(found[0], "12");
  EXPECT_EQ(found[1], "3");
}

TEST(LinePatterns, ManyGroupsAreReadAsInOneMatch) {
  std::string pattern, line;
  for (int i = 0; i < 32; ++i) {
    pattern += (i == 0 ? "" : ",") + ("(?P<g" + std::to_string(i) + ">[0-9]+)");
    line += (i == 0 ? "" : ",") + std::to_string(i * i);
  }
  const LinePattern all(pattern);
  ASSERT_EQ(all.error(), "");
  std::array<std::string_view, wire::described::most_groups> found;
  ASSERT_TRUE(all.match(line, found));
  for (std::size_t i = 0; i < 32; ++i) EXPECT_EQ(found[i], std::to_string(i * i));
  EXPECT_THAT(LinePattern(pattern + ",(?P<more>x)").error(), HasSubstr("more than 32 groups"));
}

std::string with_line(std::string_view keys) {
  return problems_of(
      "[sensor]\ntitle = \"t\"\nkind = \"depth\"\n[protocol]\n[[protocol.lines]]\nname = \"a\"\n" +
      std::string(keys));
}

constexpr std::string_view one_field =
    "fields = [{group = \"d\", field = \"depth_m\", unit = \"m\"}]\n";

TEST(PatternProblems, APatternThatCannotBeUsedIsRefusedWithItsPlace) {
  const auto with_pattern = [](std::string_view pattern) {
    return with_line("pattern = '" + std::string(pattern) + "'\n" + std::string(one_field));
  };
  EXPECT_THAT(with_pattern("D=(?P<d>[0-9.]+)"), IsEmpty());
  EXPECT_EQ(with_pattern("D=(?P<d>[0-9.+)"),
            "toy.toml:7:11: /protocol/lines/0/pattern: the pattern cannot be used: missing ]: "
            "[0-9.+)\n");
  EXPECT_THAT(with_pattern("D=([0-9.]+)"), HasSubstr("toy.toml:7:11: /protocol/lines/0/pattern: "
                                                     "the pattern cannot be used: it has no named "
                                                     "group"));
  EXPECT_THAT(with_pattern("(?P<d>[a-z]{900})(?:x{900}y{900})"), HasSubstr("it is too large"));
  EXPECT_THAT(with_pattern("(?P<d>(?:(?:x{99}){99}){99})"), HasSubstr("cannot be used: "));
  EXPECT_THAT(with_pattern("(?P<d>a)(?P<d>b)"), HasSubstr("cannot be used: "));
  EXPECT_THAT(with_pattern("\\Q(?P<e>\\E(?P<d>b)"), HasSubstr("cannot be used: "));
  EXPECT_THAT(with_pattern("(?P<d>a)\\1"), HasSubstr("invalid escape sequence: \\1"));
}

TEST(PatternProblems, AFieldNamesAGroupOfThePattern) {
  const std::string pattern = "pattern = '(?P<depth>[0-9.]+)'\n";
  EXPECT_THAT(
      with_line(pattern + "fields = [{group = \"dpeth\", field = \"depth_m\", unit = \"m\"}]\n"),
      HasSubstr("toy.toml:8:20: /protocol/lines/0/fields/0: the pattern has no group "
                "\"dpeth\" (did you mean 'depth'?), allowed: depth"));
  EXPECT_THAT(with_line(pattern + "fields = [{field = \"depth_m\", unit = \"m\"}]\n"),
              HasSubstr("needs the key 'group'"));
  EXPECT_THAT(with_line(pattern + "fields = [{group = \"depth\", text = \"m\"}]\n"),
              HasSubstr("'text' is only for fields in order"));
  EXPECT_THAT(with_line(one_field), HasSubstr("only for a line with a 'pattern'"));
  EXPECT_THAT(
      with_line("emulate = \"{d} of {e}\"\npattern = '(?P<d>a)'\n" + std::string(one_field)),
      HasSubstr("toy.toml:7:11: /protocol/lines/0/emulate: no field has the group \"e\""));
}

TEST(PatternProblems, OfTwoLinesWithAPatternTheHeadsMustDiffer) {
  const auto two = [](std::string_view head) {
    return with_line("head = \"D\"\npattern = '(?P<d>[0-9]+)'\n" + std::string(one_field) +
                     "[[protocol.lines]]\nname = \"b\"\nhead = \"" + std::string(head) +
                     "\"\npattern = '(?P<d>[a-f]+)'\n" + std::string(one_field));
  };
  EXPECT_THAT(two("E"), IsEmpty());
  EXPECT_THAT(two("D"), HasSubstr("the same bytes can be this message and that of line 5"));
}

}  // namespace pattern_test
}  // namespace drydock::described::test

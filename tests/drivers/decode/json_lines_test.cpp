#include "drivers/text/json_lines.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace drydock::decode {
namespace json_lines_test {

template <class T>
std::string written(const T& value) {
  text::JsonText text{1};
  text::JsonWriter(text).value(value);
  return std::string{text.view()};
}

struct Point {
  double x = 0;
  std::optional<int> label;
};
template <class F>
void visit_fields(const Point& p, F&& field) {
  field("x_m", p.x);
  field("label", p.label);
}

TEST(JsonWriter, NotANumberAndInfinityAreNull) {
  EXPECT_EQ(written(std::numeric_limits<double>::quiet_NaN()), "null");
  EXPECT_EQ(written(std::numeric_limits<double>::infinity()), "null");
  EXPECT_EQ(written(std::optional<double>{}), "null");
  EXPECT_EQ(written(std::string_view{}), "null");
}

TEST(JsonWriter, DoublesHaveTheFewestDigits) {
  EXPECT_EQ(written(0.1), "0.1");
  EXPECT_EQ(written(-2.0), "-2");
  EXPECT_EQ(written(1436509052.249713), "1436509052.249713");
  EXPECT_EQ(written(0.0000012), "0.0000012");
  EXPECT_EQ(written(-0.05), "-0.05");
  EXPECT_EQ(written(100000.0), "100000");
  EXPECT_EQ(written(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(written(0.1F), "0.1");
}

TEST(JsonWriter, BytesAreNumbers) {
  EXPECT_EQ(written(std::uint8_t{65}), "65");
  EXPECT_EQ(written(std::array<std::uint8_t, 3>{1, 2, 255}), "[1,2,255]");
  EXPECT_EQ(written(true), "true");
}

TEST(JsonWriter, WholeNumbersAreWholeToTheirLimits) {
  EXPECT_EQ(written(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
  EXPECT_EQ(written(std::numeric_limits<std::int64_t>::max()), "9223372036854775807");
  EXPECT_EQ(written(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
}

TEST(JsonWriter, StructsNest) {
  EXPECT_EQ(written(std::array<Point, 2>{Point{1.5, 7}, Point{}}),
            R"([{"x_m":1.5,"label":7},{"x_m":0,"label":null}])");
}

/// RFC 3629 gives these bytes to U+00B0, U+00E9 and U+2014.
TEST(JsonWriter, TextInUtf8StaysWhatItIs) {
  for (const std::string text : {"\xC2\xB0"
                                 "C",
                                 "pty:dvl-\xC3\xA9", "silent \xE2\x80\x94 look"})
    EXPECT_EQ(nlohmann::json::parse(written(text)).get<std::string>(), text);
}

TEST(JsonWriter, TextInLatin1BecomesTheSameCharacters) {
  const auto read =
      nlohmann::json::parse(written(std::string_view{"12 \xB0"
                                                     "C"}));
  EXPECT_EQ(read.get<std::string>(),
            "12 \xC2\xB0"
            "C");
}

RC_GTEST_PROP(JsonWriter, AnyBytesAreOneJsonString, (const std::string& bytes)) {
  const nlohmann::json parsed = nlohmann::json::parse(written(std::string_view(bytes)));
  if (bytes.empty()) {
    RC_ASSERT(parsed.is_null());
    return;
  }
  const auto utf8 = parsed.get<std::string>();  // the parser returns UTF-8
  if (utf8 == bytes) return;
  std::string latin1;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto lead = static_cast<unsigned char>(utf8[i]);
    latin1 += lead < 0x80 ? utf8[i] : static_cast<char>(((lead & 3) << 6) | (utf8[++i] & 0x3F));
  }
  RC_ASSERT(latin1 == bytes);
}

RC_GTEST_PROP(JsonWriter, DoublesReadBackTheSame, (double number)) {
  RC_ASSERT(nlohmann::json::parse(written(number)).get<double>() == number);
}

RC_GTEST_PROP(JsonWriter, DecimalsOfAWireHaveTheFewestDigits, ()) {
  const auto whole = *rc::gen::inRange<std::int64_t>(-1'000'000'000'000'000, 1'000'000'000'000'000);
  const double unit = *rc::gen::element(1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9);
  const double number = static_cast<double>(whole) / unit;
  const auto digits = [](std::string_view text) {
    std::string kept;
    for (const char c : text.substr(0, text.find('e'))) {
      if (c >= '0' && c <= '9' && !(kept.empty() && c == '0')) kept += c;
    }
    return kept.substr(0, kept.find_last_not_of('0') + 1);
  };
  std::array<char, 32> shortest;  // from the standard library, which guarantees it
  const char* end = std::to_chars(shortest.begin(), shortest.end(), number).ptr;
  const std::string ours = written(number);
  RC_ASSERT(digits(ours) == digits({shortest.data(), end}));
  RC_ASSERT(nlohmann::json::parse(ours).get<double>() == number);
}

}  // namespace json_lines_test
}  // namespace drydock::decode

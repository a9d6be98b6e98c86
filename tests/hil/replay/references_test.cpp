// References on a message of two fields. The bytes are written by hand.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "hil/replay/reference_check.hpp"

namespace references_test {

using namespace drydock;
using namespace drydock::replay;
using measurement::Stamp;

const bus::CdrSink::Topic depth_topic{
    "/depth", "test/msg/Depth", "float64 depth\nfloat64[2] range\n", {}};

/// Little-endian CDR of three doubles.
std::vector<std::uint8_t> message(double depth, double range = 2) {
  std::vector<std::uint8_t> cdr{0, 1, 0, 0};
  for (const double value : {depth, range, std::nan("")})
    for (int i = 0; i < 8; ++i)
      cdr.push_back(static_cast<std::uint8_t>(std::bit_cast<std::uint64_t>(value) >> (8 * i)));
  return cdr;
}

Stamp at(int tenths) { return Stamp{std::chrono::milliseconds{100} * tenths}; }

References references(std::optional<std::uint64_t> every, int count = 10) {
  ReferenceMaker maker(every);
  const auto topic = maker.add_topic(depth_topic);
  for (int i = 0; i < count; ++i) maker.put(topic, at(i), message(i));
  return parse_references(to_json_text(maker.made("all"))).value();
}

/// Checks `count` messages; the message number `other` has another depth.
std::vector<Divergence> checked(References expected, double tolerance, int other, double depth,
                                int count = 10) {
  ReferenceCheck check(std::move(expected), tolerance);
  const auto topic = check.add_topic(depth_topic);
  for (int i = 0; i < count; ++i) check.put(topic, at(i), message(i == other ? depth : i));
  return check.finish();
}

TEST(References, NameEveryValueOfAMessage) {
  const auto layout = record::parse_definition(depth_topic.schema, depth_topic.type);
  ASSERT_TRUE(layout);
  const auto values = values_of(*layout, message(3.25, 1e-300));
  ASSERT_EQ(values.size(), 3u);
  EXPECT_EQ(values[0].name, "depth");
  EXPECT_EQ(values[0].value, 3.25);
  EXPECT_EQ(values[1].name, "range[0]");
  EXPECT_EQ(values[1].value, 1e-300);
  EXPECT_EQ(values[2].name, "range[1]");
  EXPECT_TRUE(values[2].value.is_null()) << "no number is none";
}

TEST(References, AreMetByTheSameMessages) { EXPECT_TRUE(checked(references(1), 0, -1, 0).empty()); }

TEST(References, TellTheFirstValueThatDiverges) {
  const auto found = checked(references(1), 0, 4, std::nextafter(4.0, 5.0));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].field, "depth");
  EXPECT_EQ(found[0].message, 4u);
  EXPECT_EQ(found[0].at_ns, 400'000'000);
  EXPECT_EQ(to_string(found[0]),
            "/depth at 0.400000000 s (message 5): depth: expected 4.0, got 4.000000000000001");
}

TEST(References, ForgiveWithinATolerance) {
  EXPECT_TRUE(checked(references(1), 1e-9, 4, 4 + 1e-10).empty());
  EXPECT_EQ(checked(references(1), 1e-9, 4, 4 + 1e-6).size(), 1u);
  EXPECT_EQ(checked(references(1), 1e-9, 4, std::nan("")).size(), 1u);
}

TEST(References, ThinnedStillNoticeEveryByte) {
  const auto found = checked(references(4), 0, 5, 5.5);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].message, 8u) << "the next that they hold";
  EXPECT_NE(to_string(found[0]).find("the same bytes since 0.400000000 s"), std::string::npos);
  const auto behind = checked(references(4), 0, 9, 9.5);
  ASSERT_EQ(behind.size(), 1u);
  EXPECT_NE(behind[0].got.find("behind the last message"), std::string::npos);
}

TEST(References, NoticeMissingAndSurplusMessages) {
  const auto fewer = checked(references(1), 0, -1, 0, 8);
  ASSERT_EQ(fewer.size(), 1u);
  EXPECT_EQ(fewer[0].at_ns, 800'000'000);
  EXPECT_EQ(fewer[0].expected, "10 messages");
  const auto more = checked(references(1), 0, -1, 0, 12);
  ASSERT_EQ(more.size(), 1u);
  EXPECT_EQ(more[0].at_ns, 1'000'000'000);
}

TEST(References, StayAFewThousandRowsHoweverLongItTakes) {
  const auto made = references({}, 10'000);
  const auto& topic = made.topics.at("/depth");
  EXPECT_EQ(topic.messages, 10'000u);
  EXPECT_EQ(topic.every, 8u);
  ASSERT_LE(topic.rows.size(), ReferenceMaker::most_rows);
  for (std::size_t i = 0; i < topic.rows.size(); ++i)
    EXPECT_EQ(topic.rows[i].values[0], static_cast<double>(topic.every * i));
  EXPECT_TRUE(checked(made, 0, -1, 0, 10'000).empty());
}

TEST(References, ThatAreNoneAreRefusedInALine) {
  EXPECT_NE(parse_references("{}").error().line, "");
  EXPECT_NE(parse_references("{\"drydock_references\": 2}").error().line.find("version 2"),
            std::string::npos);
}

TEST(References, AreRefusedWhereAFileCannotBeMeant) {
  const auto refused = [](const std::string& topic) {
    const auto read = parse_references(
        R"({"drydock_references": 1, "part": "all", "topics": {"/t": )" + topic + "}}");
    return !read && !read.error().line.empty();
  };
  const auto rows = [](const std::string& of) {
    return R"({"type": "t", "messages": 1, "every": 1, "digest": "0", "rows": )" + of + "}";
  };
  EXPECT_FALSE(refused(rows(R"([[1, "0", [1.5, null, "x"]]])")));
  EXPECT_TRUE(refused(rows(R"([[1e300, "0", []]])")));
  EXPECT_TRUE(refused(rows(R"([[1, "0", [[1]]]])")));
  EXPECT_TRUE(refused(
      rows(R"([[1, "0", )" + std::string(100'000, '[') + std::string(100'000, ']') + "]]")));
  EXPECT_TRUE(refused(R"({"type": "t", "messages": -1, "every": 1, "digest": "0", "rows": []})"));
  EXPECT_TRUE(refused(R"({"type": "t", "messages": 1, "every": 0, "digest": "0", "rows": []})"));
}

}  // namespace references_test

#include "drivers/live/foxglove/foxglove.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace drydock::live {
namespace foxglove_test {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Foxglove, DataBeginsWithOpcodeSubscriptionAndTime) {
  EXPECT_THAT(data_head(0x01020304, 0x1112131415161718),
              ElementsAre(1, 4, 3, 2, 1, 0x18, 0x17, 0x16, 0x15, 0x14, 0x13, 0x12, 0x11));
}

TEST(Foxglove, SubscribeAndUnsubscribeAreRead) {
  // The specification's own examples.
  const auto request = parse_request(
      R"({"op":"subscribe","subscriptions":[{"id":0,"channelId":3},{"id":1,"channelId":5}]})");
  const auto& subscribe = std::get<Subscribe>(request);
  ASSERT_EQ(subscribe.subscriptions.size(), 2U);
  EXPECT_EQ(subscribe.subscriptions[1].id, 1U);
  EXPECT_EQ(subscribe.subscriptions[1].channel, 5U);
  const auto other = parse_request(R"({"op":"unsubscribe","subscriptionIds":[0,1]})");
  EXPECT_THAT(std::get<Unsubscribe>(other).ids, ElementsAre(0, 1));
}

TEST(Foxglove, WhatIsNotARequestIsRefusedWithAReason) {
  const auto why = [](std::string_view text) { return std::get<Refused>(parse_request(text)).why; };
  EXPECT_EQ(why("[]"), "a request is a JSON object");
  EXPECT_EQ(why("\xff"), "a request is a JSON object");
  EXPECT_EQ(why(R"({"op":7})"), "a request has an \"op\"");
  EXPECT_EQ(why(R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":1}]})"),
            "subscriptions: id and channelId must be numbers");
  EXPECT_EQ(why(R"({"op":"subscribe","subscriptions":[7]})"),
            "subscriptions: objects with id and channelId");
  EXPECT_THAT(why(R"({"op":"advertise"})"), HasSubstr("\"advertise\" is not served"));
  EXPECT_EQ(why(R"({"op":"subscribe"})"), "a subscribe has a list \"subscriptions\"");
}

TEST(Foxglove, BracketsInBracketsTakeNoStack) {
  // The longest message that a viewer may send holds this many.
  const std::string deep = std::string(30'000, '[') + std::string(30'000, ']');
  const auto request = parse_request(R"({"op":"subscribe","subscriptions":)" + deep + "}");
  EXPECT_EQ(std::get<Refused>(request).why, "subscriptions: objects with id and channelId");
  const auto inside =
      parse_request(R"({"op":"subscribe","subscriptions":[{"id":)" + deep + R"(,"channelId":1}]})");
  EXPECT_EQ(std::get<Refused>(inside).why, "subscriptions: id and channelId must be numbers");
}

TEST(Foxglove, ARefusalDoesNotSendBackAllThatItRefuses) {
  const auto request = parse_request(R"({"op":")" + std::string(50'000, 'x') + "\"}");
  EXPECT_LT(std::get<Refused>(request).why.size(), 100U);
}

RC_GTEST_PROP(Foxglove, AnyTextIsAnswered, (const std::string& text)) {
  const auto request = parse_request(text);
  if (const auto* refused = std::get_if<Refused>(&request)) RC_ASSERT(!refused->why.empty());
}

}  // namespace foxglove_test
}  // namespace drydock::live

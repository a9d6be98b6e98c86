#include "drivers/live/foxglove/services.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>
#include <thread>

#include "drivers/live/server.hpp"
#include "tests/npm/node.hpp"

/// The requests that a viewer may send to a server. The checks use the layout of the specification
/// and Foxglove's own client.
namespace drydock::live {
namespace services_test {

namespace asio = boost::asio;

using nlohmann::json;
using testing::HasSubstr;
using namespace std::string_literals;

std::string call(std::uint8_t service, const std::string& encoding, const std::string& request) {
  return "\2"s + static_cast<char>(service) + "\0\0\0"s + "\x46\0\0\0"s +
         static_cast<char>(encoding.size()) + "\0\0\0"s + encoding + request;
}

TEST(ServiceCalls, AreReadAsTheSpecificationLaysThemOut) {
  const std::string message = "\2\4\3\2\1\x14\x13\x12\x11\4\0\0\0json{}"s;
  const auto read = std::get<ServiceCall>(parse_call(message));
  EXPECT_EQ(read.service, 0x01020304U);
  EXPECT_EQ(read.call, 0x11121314U);
  EXPECT_EQ(read.encoding, "json");
  EXPECT_EQ(read.request, "{}");
  EXPECT_EQ(service_response(read, "[]"), "\3\4\3\2\1\x14\x13\x12\x11\4\0\0\0json[]"s);
}

TEST(ServiceCalls, ThatAreNoneAreRefusedWithAReason) {
  const auto why = [](const std::string& message) {
    return std::get<Refused>(parse_call(message)).why;
  };
  EXPECT_EQ(why(""), "a binary message is a service call: opcode 2");
  EXPECT_EQ(why("\1\0\0\0\0data"s), "a binary message is a service call: opcode 2");
  EXPECT_EQ(why(call(1, "", "").substr(0, 12)), "a service call has 13 bytes before its request");
  EXPECT_EQ(why("\2\0\0\0\0\0\0\0\0\xff\xff\xff\xffjson"s),
            "a service call ends in the name of its encoding");
}

RC_GTEST_PROP(ServiceCalls, HoldNoMoreThanTheirMessage, (const std::string& rest)) {
  const std::string message = "\2"s + rest;
  const auto read = parse_call(message);
  if (const auto* good = std::get_if<ServiceCall>(&read))
    RC_ASSERT(13 + good->encoding.size() + good->request.size() == message.size());
}

/// A server with one value. A viewer may set it to an integer below 10.
class LiveServices : public testing::Test {
 protected:
  void add_services() {
    const std::string schema = R"({"type":"object"})";
    server_.add_service({"/set", "test/Set", schema, schema, [this](auto request, auto answered) {
                           const auto asked = json::parse(request, nullptr, false);
                           if (!asked.is_object() || asked.value("value", 10) > 9)
                             return answered(Refused{"allowed: below 10"});
                           value_ = asked["value"];
                           answered(json{{"value", *value_}}.dump());
                         }});
    server_.add_service(
        {"/clear", "test/Clear", schema, schema, [this](auto, const auto& answered) {
           asio::post(io_, [this, answered] {  // answers later
             value_.reset();
             answered("{}");
           });
         }});
  }

  /// Runs `talk` in parallel with the server.
  template <class Talk>
  void beside(Talk talk) {
    ASSERT_FALSE(server_.listen());
    std::jthread client([&] {
      talk();
      asio::post(io_, [&] { server_.stop(); });
    });
    io_.run();
  }

  json call_all(const json& calls) {
    json found;
    beside([&] {
      found = drydock::test::run_node("tests/drivers/live/call.cjs", {url(), calls.dump()});
    });
    return found;
  }
  std::string url() const { return "ws://127.0.0.1:" + std::to_string(server_.port()) + "/"; }

  asio::io_context io_{1};
  Server server_{io_.get_executor(), {.port = 0}};
  std::optional<int> value_;
};

TEST_F(LiveServices, AreCalledRefusedAndAnsweredLaterForFoxglovesOwnClient) {
  DRYDOCK_NEEDS_NODE();
  add_services();
  const auto found = call_all(json::array(
      {{"/set", {{"value", 7}}}, {"/set", {{"value", 70}}}, {"/set", "{"}, {9, json::object()}}));
  ASSERT_EQ(found["answers"].size(), 4U) << found;
  EXPECT_EQ(found["server"]["capabilities"], json::array({"services"}));
  EXPECT_EQ(found["server"]["supportedEncodings"], json::array({"json"}));
  EXPECT_EQ(found["services"][0]["type"], "test/Set");
  EXPECT_EQ(found["services"][0]["request"]["schemaEncoding"], "jsonschema");
  const auto& answers = found["answers"];
  EXPECT_EQ(
      answers[0],
      (json{{"callId", 70}, {"serviceId", 1}, {"encoding", "json"}, {"response", {{"value", 7}}}}));
  EXPECT_EQ(answers[1], (json{{"callId", 71}, {"serviceId", 1}, {"failure", "allowed: below 10"}}));
  EXPECT_EQ(answers[2]["failure"], "allowed: below 10");
  EXPECT_EQ(answers[3]["failure"], "there is no service 9");
  EXPECT_EQ(value_, 7);
}

TEST_F(LiveServices, AnAnswerMayComeLater) {
  DRYDOCK_NEEDS_NODE();
  add_services();
  value_ = 3;
  const auto found = call_all(json::array({{"/clear", json::object()}}));
  EXPECT_EQ(found["answers"][0]["response"], json::object());
  EXPECT_FALSE(value_);
}

TEST_F(LiveServices, OfAServerThatOnlyShowsAreNeitherAdvertisedNorServed) {
  DRYDOCK_NEEDS_NODE();
  const auto found = call_all(json::array({{1, {{"value", 7}}}}));
  EXPECT_EQ(found["server"]["capabilities"], json::array());
  EXPECT_TRUE(found["services"].empty());
  EXPECT_EQ(found["answers"][0]["failure"], "this server only shows: it has no services");
}

TEST_F(LiveServices, MalformedCallsAreAnsweredAndTooLongOnesEndTheConnection) {
  add_services();
  std::vector<std::string> answers;
  bool ended = false;
  beside([&] {
    asio::io_context own;
    boost::beast::websocket::stream<asio::ip::tcp::socket> socket(own);
    socket.next_layer().connect({asio::ip::address_v4::loopback(), server_.port()});
    socket.handshake("localhost", "/");
    socket.binary(true);
    boost::beast::flat_buffer buffer;
    const auto said = [&] {
      socket.read(buffer);
      answers.push_back(boost::beast::buffers_to_string(buffer.data()));
      buffer.consume(buffer.size());
    };
    for (int greeting = 0; greeting < 3; ++greeting) said();
    for (const auto& message : {"\2\1"s, call(1, "cdr", "\0"s), call(1, "json", "\xff\xfe"s)}) {
      socket.write(asio::buffer(message));
      said();
    }
    boost::system::error_code error;
    socket.write(asio::buffer(call(1, "json", std::string(70'000, ' '))), error);
    while (!error) socket.read(buffer, error);
    ended = true;
  });
  ASSERT_EQ(answers.size(), 6U);
  EXPECT_THAT(answers[2], HasSubstr("advertiseServices"));
  EXPECT_THAT(answers[3], HasSubstr("13 bytes before its request"));
  EXPECT_EQ(json::parse(answers[4])["message"], "the encoding of a request is json");
  EXPECT_EQ(json::parse(answers[5])["callId"], 0x46);
  EXPECT_TRUE(ended);
  EXPECT_FALSE(value_);
}

}  // namespace services_test
}  // namespace drydock::live

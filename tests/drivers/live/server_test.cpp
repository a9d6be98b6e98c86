#include "drivers/live/server.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket.hpp>
#include <cstdlib>
#include <thread>

#include "tests/drivers/live/beside_clients.hpp"
#include "tests/npm/node.hpp"
#include "tests/test_name.hpp"

namespace drydock::live {
namespace server_test {

namespace asio = boost::asio;

constexpr auto at = measurement::stamp_from_ns(1'700'000'000'123'456'789);

/// A server on a free port with a client of another project.
class LiveServer : public testing::Test {
 protected:
  void SetUp() override { DRYDOCK_NEEDS_NODE(); }

  std::string url() const { return "ws://127.0.0.1:" + std::to_string(server_.port()) + "/"; }

  /// The result of the client, while `serve` runs every millisecond in the server's thread.
  nlohmann::json watch(int count, const std::string& subprotocol, std::function<void()> serve) {
    std::function<void()> again = [&] {
      timer_.expires_after(std::chrono::milliseconds{1});
      timer_.async_wait([&](const boost::system::error_code& error) {
        if (error || stopped_) return;  // an expired timer can no longer be cancelled
        serve();
        again();
      });
    };
    again();
    nlohmann::json found;
    std::jthread client([&] {
      found = drydock::test::run_node(
          "tests/drivers/live/watch.cjs",
          {url(), std::to_string(count), subprotocol, "/bench", "/depth/pressure"});
      asio::post(io_, [&] {
        stopped_ = true;
        server_.stop();
        timer_.cancel();
      });
    });
    io_.run();
    client.join();
    return found;
  }

  /// The answer to one HTTP request, head and body.
  std::string get(const std::string& request) {
    std::string answer;
    std::jthread client([&] {
      asio::io_context io;
      asio::ip::tcp::socket socket(io);
      socket.connect({asio::ip::address_v4::loopback(), server_.port()});
      asio::write(socket, asio::buffer(request));
      boost::system::error_code end;
      asio::read(socket, asio::dynamic_buffer(answer), end);
      asio::post(io_, [&] { server_.stop(); });
    });
    io_.run();
    return answer;
  }

  asio::io_context io_{1};
  Server server_{io_.get_executor(), {.port = 0}, {{"/", "text/html", "<title>Drydock</title>"}}};
  asio::steady_timer timer_{io_};
  bool stopped_ = false;
};

const Channel json_channel{0, "/bench", "json", "bench", R"({"type":"object"})", "jsonschema"};
const Channel cdr_channel{
    0, "/depth/pressure", "cdr", "std_msgs/msg/Float64", "float64 data\n", "ros2msg"};

class LiveServerByName : public LiveServer, public testing::WithParamInterface<const char*> {};

TEST_P(LiveServerByName, SpeaksToFoxglovesOwnClient) {
  ASSERT_FALSE(server_.listen());
  const auto bench = server_.add_channel(json_channel), depth = server_.add_channel(cdr_channel);
  const std::array<std::uint8_t, 12> cdr{0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0xF0, 0x3F};  // 1.0
  const std::string text = R"({"t":7})";
  const auto found = watch(20, GetParam(), [&] {
    server_.publish(bench, at, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    server_.publish(depth, at, cdr);
  });
  EXPECT_FALSE(found.contains("error")) << found.value("error", "");
  EXPECT_EQ(found.value("server", ""), "drydock");
  EXPECT_EQ(found["channels"]["/depth/pressure"]["schemaName"], "std_msgs/msg/Float64");
  EXPECT_EQ(found["messages"]["/bench"]["value"]["t"], 7);
  EXPECT_EQ(found["messages"]["/bench"]["timestamp"], "1700000000123456789");
  EXPECT_EQ(found["messages"]["/depth/pressure"]["value"]["data"], 1.0);
  EXPECT_GE(server_.counters().sent, 20U);
}

INSTANTIATE_TEST_SUITE_P(BothNames, LiveServerByName,
                         testing::Values("foxglove.websocket.v1", "foxglove.sdk.v1"),
                         [](const auto& one) { return drydock::test::test_name(one.param); });

TEST_F(LiveServer, AViewerThatDoesNotReadLosesMessagesAndHoldsUpNobody) {
  ASSERT_FALSE(server_.listen());
  const auto channel = server_.add_channel(json_channel);
  boost::beast::websocket::stream<asio::ip::tcp::socket> viewer(io_);
  const asio::ip::tcp::endpoint endpoint(asio::ip::address_v4::loopback(), server_.port());
  const std::vector<std::uint8_t> megabyte(1u << 20);
  asio::co_spawn(
      io_,
      [&]() -> asio::awaitable<void> {
        co_await viewer.next_layer().async_connect(endpoint, asio::use_awaitable);
        co_await viewer.async_handshake("localhost", "/", asio::use_awaitable);
        const std::string subscribe =
            R"({"op":"subscribe","subscriptions":[{"id":0,"channelId":1}]})";
        co_await viewer.async_write(asio::buffer(subscribe), asio::use_awaitable);
        while (!server_.wanted(channel)) co_await asio::post(asio::use_awaitable);
        // The client stops reading; the kernel's buffers hold a few megabytes.
        for (int i = 0; i < 100; ++i) {
          server_.publish(channel, at, megabyte);
          co_await asio::post(asio::use_awaitable);
        }
        const auto counters = server_.counters();
        EXPECT_EQ(counters.viewers, 1U);
        EXPECT_GT(counters.dropped, 50U);
        EXPECT_LT(counters.sent, 50U);
        server_.stop();
      },
      asio::detached);
  io_.run();
}

TEST_F(LiveServer, GivesItsPageAndNothingElse) {
  ASSERT_FALSE(server_.listen());
  const auto page = get("GET / HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  EXPECT_TRUE(page.starts_with("HTTP/1.1 200 OK")) << page;
  EXPECT_NE(page.find("<title>Drydock</title>"), std::string::npos);
}

TEST_F(LiveServer, RefusesANameThatIsNotLoopback) {
  ASSERT_FALSE(server_.listen());
  const auto page = get("GET / HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n");
  EXPECT_TRUE(page.starts_with("HTTP/1.1 403")) << page;
  EXPECT_EQ(page.find("Drydock"), std::string::npos);
  EXPECT_EQ(server_.counters().refused, 1U);
}

TEST_F(LiveServer, AFileThatIsNotThereIsNotFound) {
  ASSERT_FALSE(server_.listen());
  const auto page =
      get("GET /../../etc/passwd HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  EXPECT_TRUE(page.starts_with("HTTP/1.1 404")) << page;
}

TEST_F(BesideClients, NoPageMayShowWhatItAnswersInsideItself) {
  for (const std::string& request :
       {"GET /" + to_end, "HEAD /" + to_end, "POST /" + to_end, "GET /nowhere" + to_end,
        std::string("GET / HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n")}) {
    const auto answer = get(request);
    EXPECT_NE(answer.find("X-Frame-Options: DENY\r\n"), std::string::npos) << answer;
    EXPECT_NE(answer.find("frame-ancestors 'none'"), std::string::npos) << answer;
  }
}

TEST(LiveServerAddress, BeyondThisHostNeedsAToken) {
  asio::io_context io;
  Server open_to_all(io.get_executor(), {.address = "0.0.0.0", .port = 0});
  EXPECT_EQ(open_to_all.listen(), boost::system::errc::permission_denied);
  Server nowhere(io.get_executor(), {.address = "not an address", .port = 0});
  EXPECT_TRUE(nowhere.listen().failed());
}

TEST(LiveServerAddress, APortThatIsTakenIsAnError) {
  asio::io_context io;
  Server first(io.get_executor(), {.port = 0});
  ASSERT_FALSE(first.listen());
  Server second(io.get_executor(), {.port = first.port()});
  EXPECT_EQ(second.listen(), boost::system::errc::address_in_use);
}

}  // namespace server_test
}  // namespace drydock::live

#include "drivers/live/server.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket.hpp>
#include <cstdlib>
#include <list>
#include <thread>

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

/// Requests of one letter as a browser sends them: RFC 6455, masked with a key of zeros.
std::string requests(int count) {
  constexpr std::string_view one("\x81\x81\0\0\0\0x", 7);
  std::string all;
  for (int i = 0; i < count; ++i) all += one;
  return all;
}

/// A client that sends requests and reads no answer. Returns how its connection ended.
boost::system::error_code ask_and_take_nothing(std::uint16_t port) {
  asio::io_context own;
  boost::beast::websocket::stream<asio::ip::tcp::socket> socket(own);
  boost::system::error_code error;
  socket.next_layer().connect({asio::ip::address_v4::loopback(), port}, error);
  socket.handshake("127.0.0.1", "/", error);
  // The server answers each with a line; the sockets' buffers hold some thousands of lines. Many
  // requests go in one write: after many small ones the kernel drops segments and stalls.
  const std::string many = requests(20'000);
  for (int i = 0; i < 100 && !error; ++i)
    asio::write(socket.next_layer(), asio::buffer(many), error);
  return error;
}

TEST(LiveServerQueue, AViewerThatAsksAndTakesNoAnswerIsDisconnected) {
  asio::io_context io{1};
  Server server(io.get_executor(), {.port = 0});
  ASSERT_FALSE(server.listen());
  boost::system::error_code ended;
  std::jthread client([&, port = server.port()] {
    ended = ask_and_take_nothing(port);
    asio::post(io, [&] { server.stop(); });
  });
  io.run();
  client.join();
  EXPECT_TRUE(ended == asio::error::connection_reset || ended == asio::error::broken_pipe) << ended;
  EXPECT_EQ(server.counters().viewers, 0U);
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

/// A server whose clients have 300 ms for a request. It runs beside the clients of the test.
class BesideClients : public testing::Test {
 protected:
  using Tcp = asio::ip::tcp;

  BesideClients() {
    EXPECT_FALSE(server_.listen());
    port_ = server_.port();
    thread_ = std::jthread([this] { io_.run(); });
  }
  ~BesideClients() override {
    asio::post(io_, [this] { server_.stop(); });
    clients_.clear();
    thread_.join();
  }
  Tcp::socket& connect() {
    clients_.emplace_back(own_);
    clients_.back().connect({asio::ip::address_v4::loopback(), port_});
    return clients_.back();
  }
  /// Everything that the server sends until it closes the connection.
  static std::string rest_of(Tcp::socket& socket) {
    std::string answer;
    boost::system::error_code end;
    asio::read(socket, asio::dynamic_buffer(answer), end);
    return answer;
  }
  std::string get(const std::string& request) {
    auto& socket = connect();
    boost::system::error_code gone;
    asio::write(socket, asio::buffer(request), gone);
    return rest_of(socket);
  }

  asio::io_context io_{1}, own_;
  Server server_{io_.get_executor(),
                 {.port = 0, .patience = std::chrono::milliseconds{300}},
                 {{"/", "text/html", "<title>Drydock</title>"}}};
  std::uint16_t port_ = 0;
  std::list<Tcp::socket> clients_;
  std::jthread thread_;
};

const std::string to_end = " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n";

TEST_F(BesideClients, NoPageMayShowWhatItAnswersInsideItself) {
  for (const std::string& request :
       {"GET /" + to_end, "HEAD /" + to_end, "POST /" + to_end, "GET /nowhere" + to_end,
        std::string("GET / HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n")}) {
    const auto answer = get(request);
    EXPECT_NE(answer.find("X-Frame-Options: DENY\r\n"), std::string::npos) << answer;
    EXPECT_NE(answer.find("frame-ancestors 'none'"), std::string::npos) << answer;
  }
}

/// Each of 200 clients begins a request and says no more; the server serves 64 at once.
TEST_F(BesideClients, ManyThatNeverFinishARequestKeepNobodyOut) {
  for (int i = 0; i < 200; ++i) asio::write(connect(), asio::buffer("GET / HT", 8));
  const auto page = get("GET /" + to_end);
  EXPECT_NE(page.find("<title>Drydock</title>"), std::string::npos) << page;
  EXPECT_EQ(rest_of(clients_.front()), "") << "the oldest gave way";
}

/// Each of 100 clients asks for a page of 1 MB and takes none of it.
TEST(LiveServerClients, ManyThatTakeNoAnswerKeepNobodyOut) {
  using Tcp = asio::ip::tcp;
  asio::io_context io{1}, own;
  const std::string large(1u << 20, 'x');
  Server server(io.get_executor(), {.port = 0},
                {{"/", "text/html", "<title>Drydock</title>"}, {"/large", "text/plain", large}});
  ASSERT_FALSE(server.listen());
  std::jthread serving([&] { io.run(); });
  std::list<Tcp::socket> clients;
  const auto ask = [&](const std::string& what) -> Tcp::socket& {
    auto& socket = clients.emplace_back(own);
    socket.open(Tcp::v4());
    socket.set_option(asio::socket_base::receive_buffer_size(4096));
    socket.connect({asio::ip::address_v4::loopback(), server.port()});
    boost::system::error_code gone;
    asio::write(socket, asio::buffer(what + to_end), gone);
    return socket;
  };
  for (int i = 0; i < 100; ++i) ask("GET /large");
  std::string page;
  boost::system::error_code end;
  asio::read(ask("GET /"), asio::dynamic_buffer(page), end);
  EXPECT_NE(page.find("<title>Drydock</title>"), std::string::npos) << page;
  asio::post(io, [&] { server.stop(); });
  clients.clear();
}

/// 64 viewers, as many as are let in, answer no ping: they have gone, though their sockets stand.
TEST(LiveServerClients, ViewersThatHaveGoneGiveTheirPlaces) {
  using Tcp = asio::ip::tcp;
  asio::io_context io{1}, own;
  Server server(io.get_executor(), {.port = 0, .silence = std::chrono::milliseconds{200}},
                {{"/", "text/html", "<title>Drydock</title>"}});
  ASSERT_FALSE(server.listen());
  std::jthread serving([&] { io.run(); });
  std::list<Tcp::socket> clients;
  const auto ask = [&](const std::string& what) -> Tcp::socket& {
    auto& socket = clients.emplace_back(own);
    socket.connect({asio::ip::address_v4::loopback(), server.port()});
    boost::system::error_code gone;
    asio::write(socket, asio::buffer(what + to_end), gone);
    return socket;
  };
  const std::string upgrade =
      "GET / HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
      "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n";
  for (int i = 0; i < 64; ++i) {
    auto& socket = clients.emplace_back(own);
    socket.connect({asio::ip::address_v4::loopback(), server.port()});
    asio::write(socket, asio::buffer(upgrade));
    std::string answer;
    asio::read_until(socket, asio::dynamic_buffer(answer), "\r\n\r\n");
    ASSERT_TRUE(answer.starts_with("HTTP/1.1 101")) << answer;
  }
  std::string page;
  const auto begin = std::chrono::steady_clock::now();
  while (page.empty() && std::chrono::steady_clock::now() - begin < std::chrono::seconds{10}) {
    boost::system::error_code end;
    asio::read(ask("GET /"), asio::dynamic_buffer(page), end);
  }
  EXPECT_NE(page.find("<title>Drydock</title>"), std::string::npos) << page;
  asio::post(io, [&] { server.stop(); });
  clients.clear();
}

/// 100 viewers connect and never say or read anything more; a viewer that has asked for something
/// keeps its place.
TEST_F(BesideClients, ViewersThatNeverReadGiveWayToNewerOnes) {
  const std::string upgrade =
      "GET / HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
      "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n";
  const auto view = [&]() -> Tcp::socket& {
    auto& socket = connect();
    asio::write(socket, asio::buffer(upgrade));
    std::string answer;
    boost::system::error_code gone;
    asio::read_until(socket, asio::dynamic_buffer(answer), "\r\n\r\n", gone);
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 101")) << answer << gone;
    return socket;
  };
  const auto is_answered = [](Tcp::socket& viewer) {
    asio::write(viewer, asio::buffer(requests(1)));
    std::string said;
    boost::system::error_code gone;
    asio::read_until(viewer, asio::dynamic_buffer(said), "\"level\"", gone);
    return !gone;
  };
  Tcp::socket& asking = view();
  ASSERT_TRUE(is_answered(asking));
  for (int i = 0; i < 100; ++i) view();
  const auto page = get("GET /" + to_end);
  EXPECT_NE(page.find("<title>Drydock</title>"), std::string::npos) << page;
  EXPECT_TRUE(is_answered(asking));
}

/// 16 bytes, one each 100 ms: each comes within the time, the request does not.
TEST_F(BesideClients, AByteNowAndThenProlongsNoRequest) {
  auto& socket = connect();
  boost::system::error_code gone;
  int sent = 0;
  for (; sent < 16 && !gone; ++sent) {
    asio::write(socket, asio::buffer(&"GET / HTTP/1.1\r\n"[sent], 1), gone);
    std::this_thread::sleep_for(std::chrono::milliseconds{100});
    if (socket.available(gone) == 0 && !gone) {
      char none = 0;
      socket.non_blocking(true);
      socket.receive(asio::buffer(&none, 1), asio::socket_base::message_peek, gone);
      if (gone == asio::error::would_block) gone.clear();
    }
  }
  EXPECT_LT(sent, 16);
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

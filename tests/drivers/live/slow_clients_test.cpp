#include <gtest/gtest.h>

#include <boost/beast/websocket.hpp>

#include "tests/drivers/live/beside_clients.hpp"

/// Clients that do not say, take or answer what they should: they hold up nobody else.
namespace drydock::live {
namespace slow_clients_test {

namespace asio = boost::asio;

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

/// Each of 200 clients begins a request and says no more; the server serves 64 at once.
TEST_F(BesideClients, ManyThatNeverFinishARequestKeepNobodyOut) {
  for (int i = 0; i < 200; ++i) asio::write(connect(), asio::buffer("GET / HT", 8));
  const auto page = get("GET /" + to_end);
  EXPECT_NE(page.find("<title>Drydock</title>"), std::string::npos) << page;
  EXPECT_EQ(rest_of(clients_.front()), "") << "the oldest gave way";
}

const std::string large(1u << 20, 'x');

/// A viewer that answers no ping has 200 ms.
class LiveServerClients : public BesideClients {
 protected:
  LiveServerClients()
      : BesideClients(
            {.port = 0, .silence = std::chrono::milliseconds{200}},
            {{"/", "text/html", "<title>Drydock</title>"}, {"/large", "text/plain", large}}) {}
};

/// Each of 100 clients asks for a page of 1 MB and takes none of it.
TEST_F(LiveServerClients, ManyThatTakeNoAnswerKeepNobodyOut) {
  for (int i = 0; i < 100; ++i) ask("GET /large" + to_end, 4096);
  const auto page = get("GET /" + to_end);
  EXPECT_NE(page.find("<title>Drydock</title>"), std::string::npos) << page;
}

/// 64 viewers, as many as are let in, answer no ping: they have gone, though their sockets stand.
TEST_F(LiveServerClients, ViewersThatHaveGoneGiveTheirPlaces) {
  for (int i = 0; i < 64; ++i) view();
  std::string page;
  const auto begin = std::chrono::steady_clock::now();
  while (page.empty() && std::chrono::steady_clock::now() - begin < std::chrono::seconds{10})
    page = get("GET /" + to_end);
  EXPECT_NE(page.find("<title>Drydock</title>"), std::string::npos) << page;
}

/// 100 viewers connect and never say or read anything more; a viewer that has asked for something
/// keeps its place.
TEST_F(BesideClients, ViewersThatNeverReadGiveWayToNewerOnes) {
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

}  // namespace slow_clients_test
}  // namespace drydock::live

#pragma once

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>
#include <list>
#include <string>
#include <thread>
#include <vector>

#include "drivers/live/server.hpp"

namespace drydock::live {

/// What follows the method and the path of a request that is the last one of its connection.
inline const std::string to_end = " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n";

/// A server that runs beside the clients of the test, each with a socket of its own. A client has
/// 300 ms for a request.
class BesideClients : public testing::Test {
 protected:
  using Tcp = boost::asio::ip::tcp;

  explicit BesideClients(
      ServerOptions options = {.port = 0, .patience = std::chrono::milliseconds{300}},
      std::vector<PageFile> page = {{"/", "text/html", "<title>Drydock</title>"}})
      : server_(io_.get_executor(), std::move(options), std::move(page)) {
    EXPECT_FALSE(server_.listen());
    port_ = server_.port();
    thread_ = std::jthread([this] { io_.run(); });
  }
  ~BesideClients() override {
    boost::asio::post(io_, [this] { server_.stop(); });
    clients_.clear();
    thread_.join();
  }
  /// A client whose kernel takes about `window` bytes that it does not read; 0: the usual number.
  Tcp::socket& connect(int window = 0) {
    auto& socket = clients_.emplace_back(own_);
    socket.open(Tcp::v4());
    if (window > 0) socket.set_option(boost::asio::socket_base::receive_buffer_size(window));
    socket.connect({boost::asio::ip::address_v4::loopback(), port_});
    return socket;
  }
  Tcp::socket& ask(const std::string& request, int window = 0) {
    auto& socket = connect(window);
    boost::system::error_code gone;
    boost::asio::write(socket, boost::asio::buffer(request), gone);
    return socket;
  }
  /// A client that has become a viewer and says nothing more.
  Tcp::socket& view() {
    auto& socket =
        ask("GET / HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n");
    std::string answer;
    boost::system::error_code gone;
    boost::asio::read_until(socket, boost::asio::dynamic_buffer(answer), "\r\n\r\n", gone);
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 101")) << answer << gone;
    return socket;
  }
  /// Everything that the server sends until it closes the connection.
  static std::string rest_of(Tcp::socket& socket) {
    std::string answer;
    boost::system::error_code end;
    boost::asio::read(socket, boost::asio::dynamic_buffer(answer), end);
    return answer;
  }
  std::string get(const std::string& request) { return rest_of(ask(request)); }

  boost::asio::io_context io_{1}, own_;
  Server server_;
  std::uint16_t port_ = 0;
  std::list<Tcp::socket> clients_;
  std::jthread thread_;
};

}  // namespace drydock::live

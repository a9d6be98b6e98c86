#include "drivers/link/net/tcp_options.hpp"

#include <netinet/tcp.h>
#include <sys/socket.h>

namespace drydock::link {
namespace {

constexpr int gone_after_ms = 5000;
// A silent peer is asked after 2 s, then every second; the third question without an answer ends
// it.
constexpr int idle_s = 2, interval_s = 1, questions = 3;

void set_option(boost::asio::ip::tcp::socket& socket, int level, int name, int value) {
  ::setsockopt(socket.native_handle(), level, name, &value, sizeof value);
}

}  // namespace

void set_up(boost::asio::ip::tcp::socket& socket) {
  set_option(socket, IPPROTO_TCP, TCP_NODELAY, 1);
  set_option(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, gone_after_ms);
  set_option(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set_option(socket, IPPROTO_TCP, TCP_KEEPIDLE, idle_s);
  set_option(socket, IPPROTO_TCP, TCP_KEEPINTVL, interval_s);
  set_option(socket, IPPROTO_TCP, TCP_KEEPCNT, questions);
}

}  // namespace drydock::link

#include <netinet/tcp.h>
#include <sys/socket.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>

#include "drivers/link/net/endpoint.hpp"
#include "drivers/link/net/tcp.hpp"

namespace drydock::link {
namespace {

using asio::ip::tcp;

/// A device that does not answer for this long is gone (cable pulled, power off).
constexpr unsigned gone_after_ms = 5000;

void set_option(tcp::socket& socket, int level, int name, int value) {
  ::setsockopt(socket.native_handle(), level, name, &value, sizeof value);
}

void set_up(tcp::socket& socket) {
  set_option(socket, IPPROTO_TCP, TCP_NODELAY, 1);
  set_option(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, gone_after_ms);
  set_option(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set_option(socket, IPPROTO_TCP, TCP_KEEPIDLE, 2);
  set_option(socket, IPPROTO_TCP, TCP_KEEPINTVL, 1);
  set_option(socket, IPPROTO_TCP, TCP_KEEPCNT, 3);
}

class TcpClient final : public ByteLink {
 public:
  TcpClient(tcp::socket socket, Provenance provenance)
      : socket_(std::move(socket)), provenance_(provenance) {}

  Task<ReceivedBytes> read(std::span<std::uint8_t> into) override {
    if (const auto ready = co_await connected(); !ready) co_return ready.error();
    const auto [error, size] =
        co_await socket_.async_read_some(asio::buffer(into.data(), into.size()), as_outcome);
    if (error) co_return error;
    co_return ReceivedBytes{size, now()};
  }

  Task<void> write(std::span<const std::uint8_t> bytes) override {
    if (const auto ready = co_await connected(); !ready) co_return ready.error();
    const auto [error, size] =
        co_await asio::async_write(socket_, asio::buffer(bytes.data(), bytes.size()), as_outcome);
    if (error) co_return error;
    co_return boost::system::result<void>{};
  }

  void say_last(std::span<const std::uint8_t> bytes) override {
    if (connected_) ::send(socket_.native_handle(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }

  void close() override {
    boost::system::error_code already_gone;
    socket_.close(already_gone);
  }

  Provenance provenance() const override { return provenance_; }

 private:
  Task<void> connected();

  tcp::socket socket_;
  Provenance provenance_;
  bool connected_ = false;
  boost::system::error_code failure_;  ///< the kernel reports it once; read and write need it
};

Task<void> TcpClient::connected() {
  if (!connected_ && !failure_) {
    const auto [error] = co_await socket_.async_wait(tcp::socket::wait_write, as_outcome);
    if (error) co_return error;
    int number = 0;
    socklen_t size = sizeof number;
    ::getsockopt(socket_.native_handle(), SOL_SOCKET, SO_ERROR, &number, &size);
    if (number != 0) failure_ = system_error(number);
    connected_ = !failure_;
  }
  if (failure_) co_return failure_;
  co_return boost::system::result<void>{};
}

}  // namespace

OpenedBytes open_tcp_client(const asio::any_io_executor& executor, const Uri& uri) {
  const auto endpoint = tcp_endpoint(uri);
  if (!endpoint) return endpoint.error();
  tcp::socket socket(executor);
  boost::system::error_code error;
  socket.open(endpoint->protocol(), error);
  if (!error) socket.native_non_blocking(true, error);
  if (error) return OpenError{error, "cannot open a socket: " + error.message()};
  set_up(socket);
  if (::connect(socket.native_handle(), endpoint->data(),
                static_cast<socklen_t>(endpoint->size())) != 0 &&
      errno != EINPROGRESS)
    return open_error(errno, "cannot connect to " + uri.target);
  const auto provenance = uri.emulated() ? Provenance::emulated : Provenance::real;
  return std::make_unique<TcpClient>(std::move(socket), provenance);
}

}  // namespace drydock::link

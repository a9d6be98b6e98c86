#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/asio/experimental/awaitable_operators.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>

#include "drivers/link/net/endpoint.hpp"
#include "drivers/link/net/first_use.hpp"
#include "drivers/link/net/tcp.hpp"
#include "drivers/link/net/tcp_options.hpp"

namespace drydock::link {
namespace {

using asio::ip::tcp;

class TcpClient final : public ByteLink {
 public:
  TcpClient(const asio::any_io_executor& executor, const HostAndPort& address,
            Provenance provenance)
      : host_(executor, address.host),
        port_(address.port),
        socket_(executor),
        timer_(executor),
        connection_(executor, [this] { return connect(); }),
        provenance_(provenance) {}

  Task<ReceivedBytes> read(std::span<std::uint8_t> into) override {
    if (const auto ready = co_await connection_.done(); !ready) co_return ready.error();
    const auto [error, size] =
        co_await socket_.async_read_some(asio::buffer(into.data(), into.size()), as_outcome);
    if (error) co_return error;
    co_return ReceivedBytes{size, now()};
  }

  Task<void> write(std::span<const std::uint8_t> bytes) override {
    if (const auto ready = co_await connection_.done(); !ready) co_return ready.error();
    const auto [error, size] =
        co_await asio::async_write(socket_, asio::buffer(bytes.data(), bytes.size()), as_outcome);
    if (error) co_return error;
    co_return boost::system::result<void>{};
  }

  void say_last(std::span<const std::uint8_t> bytes) override {
    if (socket_.is_open())
      ::send(socket_.native_handle(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }

  void close() override {
    connection_.close();
    host_.stop();
    boost::system::error_code already_gone;
    socket_.close(already_gone);
  }

  Provenance provenance() const override { return provenance_; }

 private:
  asio::awaitable<ErrorCode> connect();
  asio::awaitable<ErrorCode> connect_to(const tcp::endpoint& endpoint,
                                        std::chrono::milliseconds limit);

  Host host_;
  std::uint16_t port_;
  tcp::socket socket_;
  asio::steady_timer timer_;  ///< the limit of one address
  FirstUse connection_;
  Provenance provenance_;
};

asio::awaitable<ErrorCode> TcpClient::connect() {
  const auto addresses = co_await host_.addresses();
  if (!addresses) co_return addresses.error();
  ErrorCode error;
  const std::size_t tried = std::min(addresses->size(), most_addresses);
  for (std::size_t i = 0; i < tried; ++i) {
    error = co_await connect_to({(*addresses)[i], port_}, limit_per_address(tried));
    if (!error || connection_.closed()) break;
  }
  co_return error;
}

asio::awaitable<ErrorCode> TcpClient::connect_to(const tcp::endpoint& endpoint,
                                                 std::chrono::milliseconds limit) {
  using namespace asio::experimental::awaitable_operators;
  ErrorCode error;
  socket_.close(error);
  socket_.open(endpoint.protocol(), error);
  if (error) co_return error;
  set_up(socket_);
  timer_.expires_after(limit);
  const auto first =
      co_await (socket_.async_connect(endpoint, as_outcome) || timer_.async_wait(as_outcome));
  const auto* connected = std::get_if<0>(&first);
  co_return connected != nullptr ? std::get<0>(*connected) : asio::error::timed_out;
}

}  // namespace

OpenedBytes open_tcp_client(const asio::any_io_executor& executor, const Uri& uri) {
  const auto provenance = uri.emulated() ? Provenance::emulated : Provenance::real;
  return std::make_unique<TcpClient>(executor, host_and_port(uri.target), provenance);
}

}  // namespace drydock::link
